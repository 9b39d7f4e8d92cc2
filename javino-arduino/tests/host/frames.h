/** @file Frames as a far end writes and reads them, made from the protocol's definition and not with the library. */
#ifndef FRAMES_H
#define FRAMES_H

#include <doctest/doctest.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

/** The nonce of the newest hello(): frames are those of this session. */
inline unsigned session = 7;

inline unsigned crcOf(const std::string &bytes, unsigned nonce = 0) {
  unsigned crc = 0xFFFF ^ nonce << 8;
  for (unsigned char byte : bytes) {
    crc ^= static_cast<unsigned>(byte) << 8;
    for (int i = 0; i < 8; i++)
      crc = ((crc << 1) ^ (crc & 0x8000 ? 0x1021 : 0)) & 0xFFFF;
  }
  return crc;
}

inline std::string hexOf(unsigned value, int digits) {
  char text[9];
  snprintf(text, sizeof text, "%0*X", digits, value);
  return text;
}

inline char octet(unsigned value) {
  return static_cast<char>(value);
}

/** Returns the bytes of a row of hexadecimal digits; spaces do not count. */
inline std::string bytesOf(const std::string &hex) {
  std::string bytes;
  for (size_t i = 0; i + 1 < hex.size(); i += 2) {
    while (hex[i] == ' ')
      i++;
    bytes += octet(static_cast<unsigned>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

inline std::string hexOf(const std::string &bytes) {
  std::string hex;
  for (unsigned char byte : bytes) {
    char two[3];
    snprintf(two, sizeof two, "%02x", byte);
    hex += two;
  }
  return hex;
}

/** Returns the ISO 8859-1 bytes of a text in UTF-8. */
inline std::string latin1(const std::string &text) {
  std::string bytes;
  for (size_t i = 0; i < text.size(); i++) {
    unsigned char c = static_cast<unsigned char>(text[i]);
    bytes += c < 0x80 ? text[i] : octet((c & 3u) << 6 | (static_cast<unsigned char>(text[++i]) & 0x3Fu));
  }
  return bytes;
}

inline std::string frame1(const std::string &payload) {
  return "fffe" + hexOf(static_cast<unsigned>(payload.size()), 2) + payload;
}

/** Returns true if frames of this kind have the same checksum in all sessions. */
inline bool beginsSessions(unsigned kind) {
  return kind == 0x10 || (kind & 0x9F) == 0x80;
}

/** A frame of version 2, of the session with this nonce. */
inline std::string frame2(unsigned kind, unsigned number, const std::string &payload = "", unsigned nonce = session) {
  std::string body = std::string{octet(static_cast<unsigned>(payload.size())), octet(kind), octet(number)} + payload;
  unsigned crc = crcOf(body, beginsSessions(kind) ? 0 : nonce);
  body += {octet(crc >> 8), octet(crc)};
  std::string frame = "\xA5";
  for (char c : body)
    if (c == octet(0xA4) || c == octet(0xA5))
      frame += {octet(0xA4), octet(static_cast<uint8_t>(c) & 0x0F)};
    else
      frame += c;
  return frame;
}

/** A command as text in a row. */
inline std::string item(const std::string &text) {
  std::string length(1, octet(static_cast<unsigned>(text.size())));
  return (text.size() < 0x80 ? length : std::string(1, '\0') + length) + text;
}

/** A command that sets or removes rules, in a row. */
inline std::string ruleItem(const std::string &text) {
  return std::string{octet(0xFF), octet(static_cast<unsigned>(text.size()))} + text;
}

inline std::string hello(unsigned nonce = 7) {
  session = nonce;
  return frame2(0x10, nonce);
}

inline std::string ask(unsigned number, unsigned known = 0, const std::string &functors = "") {
  return frame2(0x20, number, octet(known) + functors);
}

inline std::string describe(unsigned number, unsigned first = 0) {
  return frame2(0x28, number, std::string(1, octet(first)));
}

/** One command as text; first is its number. */
inline std::string command(unsigned first, const std::string &text) {
  return frame2(0x30, first, item(text));
}

/** Returns the board's acknowledgement of commands. */
inline std::string ack(unsigned due, unsigned flags = 0) {
  return frame2(0x81 | flags, due);
}

const unsigned REFUSED = 0x40, BUSY = 0x20;

struct Frame2 {
  unsigned kind, number;
  std::string payload;
};

/** Returns the frames of version 2 that follow each other, of this session; the test fails if the bytes are anything else. */
inline std::vector<Frame2> frames2(const std::string &bytes, unsigned nonce = session) {
  std::vector<Frame2> found;
  for (size_t at = 0; at < bytes.size();) {
    REQUIRE(bytes[at] == octet(0xA5));
    std::string body;
    for (at++; at < bytes.size() && bytes[at] != octet(0xA5); at++)
      if (bytes[at] == octet(0xA4))
        body += octet(0xA0 | static_cast<uint8_t>(bytes[++at]));
      else
        body += bytes[at];
    REQUIRE(body.size() >= 5);
    REQUIRE(body.size() == 5u + static_cast<uint8_t>(body[0]));
    found.push_back({static_cast<uint8_t>(body[1]), static_cast<uint8_t>(body[2]), body.substr(3, body.size() - 5)});
    unsigned crc = crcOf(body.substr(0, body.size() - 2), beginsSessions(static_cast<uint8_t>(body[1])) ? 0 : nonce);
    REQUIRE(body.substr(body.size() - 2) == std::string{octet(crc >> 8), octet(crc)});
  }
  return found;
}

/** The texts of answers, as a computer reads them: it keeps the shapes of a session. */
class Percepts {
public:
  /** The number of shapes that it knows without a gap. */
  unsigned known() const {
    unsigned n = 0;
    while (n < shapes_.size() && !shapes_[n].empty())
      n++;
    return n;
  }

  /** Returns the text of one answer to this request from the bytes of its parts; the test fails if there is anything else. */
  std::string read(const std::string &bytes, unsigned request) {
    std::string items;
    unsigned part = 0;
    bool ended = false;
    for (const Frame2 &frame : frames2(bytes)) {
      unsigned kind = frame.kind & ~(REFUSED | BUSY);
      REQUIRE(!ended);
      REQUIRE(!frame.payload.empty());
      REQUIRE(static_cast<uint8_t>(frame.payload[0]) == request);
      ended = kind != 0x83;
      REQUIRE(kind == (part ? (ended ? 0x84u : 0x83u) : (ended ? 0x82u : 0x83u)));
      if (kind != 0x82)
        REQUIRE(static_cast<uint8_t>(frame.payload.at(1)) == part++);
      items += frame.payload.substr(kind == 0x82 ? 1 : 2);
    }
    REQUIRE(ended);
    return text(items);
  }

  std::string text(const std::string &items) {
    std::string all;
    bool continued = false;
    for (size_t at = 0; at < items.size();) {
      unsigned head = static_cast<uint8_t>(items.at(at)), n = static_cast<uint8_t>(items.at(at + 1));
      at += 2;
      if (head >= 0x80) {
        REQUIRE(!continued);
        at = digits(items, at, head - 0x80, n, all);
        continue;
      }
      REQUIRE(at + n <= items.size());
      std::string text = items.substr(at, n);
      at += n;
      all += text;
      if (head < 0x7E) {
        REQUIRE(!continued);
        if (shapes_.size() <= head)
          shapes_.resize(head + 1);
        shapes_[head] = text;
      }
      continued = head == 0x7E;
    }
    REQUIRE(!continued);
    return all;
  }

private:
  std::vector<std::string> shapes_;

  static bool isDigit(char c) { return c >= '0' && c <= '9'; }

  size_t digits(const std::string &items, size_t at, unsigned id, unsigned n, std::string &all) {
    size_t half = 2 * at;
    auto next = [&] {
      unsigned byte = static_cast<uint8_t>(items.at(half / 2));
      return half++ % 2 ? byte & 15 : byte >> 4;
    };
    for (; n > 0; n--, id++) {
      REQUIRE(id < shapes_.size());
      const std::string shape = shapes_[id];
      REQUIRE(!shape.empty());
      for (size_t i = 0; i < shape.size(); i++) {
        if (!isDigit(shape[i])) {
          all += shape[i];
          continue;
        }
        while (i + 1 < shape.size() && isDigit(shape[i + 1]))
          i++;
        unsigned value;
        while ((value = next()) != 15) {
          REQUIRE(value < 10);
          all += octet('0' + value);
        }
      }
    }
    if (half % 2)
      REQUIRE(next() == 15);
    return half / 2;
  }
};

#endif
