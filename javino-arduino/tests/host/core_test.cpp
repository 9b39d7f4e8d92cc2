// The decoder, the encoder and the checksum against the published vectors and against noise.

#include <doctest/doctest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "frames.h"
#include "javino_board.h"

using nlohmann::json;

namespace {

std::string bytesOf(const std::string &hex) {
  std::string bytes;
  for (size_t i = 0; i < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return bytes;
}

std::string hexOf(const std::string &bytes) {
  std::string hex;
  for (unsigned char byte : bytes) {
    char two[3];
    snprintf(two, sizeof two, "%02x", byte);
    hex += two;
  }
  return hex;
}

const json &vectors() {
  static const json all = json::parse(std::ifstream(VECTORS));
  return all;
}

json messageOf(const javino_frame &frame) {
  std::string payload(reinterpret_cast<const char *>(frame.payload), frame.length);
  json message = {{"version", frame.version}, {"hex", hexOf(payload)}};
  if (frame.version == 2) {
    message["flags"] = frame.control >> 4;
    message["sequence"] = frame.control & JAVINO_SEQUENCE;
  }
  return message;
}

/** A decoder with exactly the memory it asks for, so that the sanitizer sees every byte too far. */
struct Receiver {
  std::vector<uint8_t> memory = std::vector<uint8_t>(JAVINO_WINDOW);
  javino_decoder decoder;
  json messages = json::array();

  explicit Receiver(uint16_t timeout = 100) {
    javino_decoder_init(&decoder, memory.data(), JAVINO_WINDOW, timeout);
  }

  void idle(uint16_t now) {
    javino_frame frame;
    while (javino_decoder_next(&decoder, now, &frame))
      messages.push_back(messageOf(frame));
  }

  void receive(const std::string &bytes, uint16_t now) {
    idle(now);
    for (unsigned char byte : bytes) {
      REQUIRE(javino_decoder_ready(&decoder));
      javino_decoder_put(&decoder, byte, now);
      idle(now);
    }
  }
};

bool readsBoth(const json &receivers) {
  return std::find(receivers.begin(), receivers.end(), json{1, 2}) != receivers.end();
}

void collect(void *text, uint8_t byte) {
  *static_cast<std::string *>(text) += static_cast<char>(byte);
}

}  // namespace

TEST_CASE("the checksum is that of the vectors") {
  for (const json &c : vectors()["crc"]) {
    INFO(c["name"]);
    uint16_t crc = JAVINO_CRC_START;
    for (unsigned char byte : bytesOf(c["hex"]))
      crc = javino_crc16(crc, byte);
    CHECK(::hexOf(crc, 4) == c["crc"]);
  }
}

TEST_CASE("frames are written as in the vectors") {
  for (const json &c : vectors()["encode"]) {
    INFO(c["name"]);
    std::string out;
    std::string payload = bytesOf(c["hex"]);
    javino_encoder encoder = {collect, &out, 0, 0};
    int control = c["version"] == 2 ? c["flags"].get<int>() << 4 | c["sequence"].get<int>() : 0;
    javino_encoder_begin(&encoder, c["version"], static_cast<uint8_t>(control), static_cast<uint8_t>(payload.size()));
    for (unsigned char byte : payload)
      javino_encoder_put(&encoder, byte);
    javino_encoder_end(&encoder);
    CHECK(hexOf(out) == c["frame"]);
  }
}

TEST_CASE("long messages are cut into the fragments of the vectors") {
  for (const json &c : vectors()["fragment"]) {
    INFO(c["name"]);
    std::string out, expected;
    std::vector<uint8_t> memory(JAVINO_MEMORY);
    javino_board board;
    javino_board_init(&board, memory.data(), JAVINO_MEMORY, collect, &out);
    board.link.frame.version = 2;
    board.link.sequence = c["sequence"];
    std::string payload = bytesOf(c["hex"]);
    CHECK(javino_board_send(&board, payload.data(), payload.size()));
    for (const json &frame : c["frames"])
      expected += frame.get<std::string>();
    CHECK(hexOf(out) == expected);
  }
}

TEST_CASE("what arrives is read as in the vectors") {
  int cases = 0;
  for (const json &c : vectors()["decode"]) {
    if (!readsBoth(c["receivers"]))
      continue;
    cases++;
    // The clock starts anywhere, so that it also wraps around.
    for (uint16_t start : {0, 12345, 65500}) {
      INFO(c["name"]);
      Receiver receiver(c["timeoutMs"]);
      uint16_t now = start;
      for (const json &chunk : c["chunks"]) {
        now = static_cast<uint16_t>(now + chunk["gapMs"].get<int>());
        receiver.receive(bytesOf(chunk["hex"]), now);
        if (chunk.contains("delivered"))
          CHECK(receiver.messages.size() == chunk["delivered"]);
      }
      receiver.idle(static_cast<uint16_t>(now + c["endGapMs"].get<int>()));
      CHECK(receiver.messages == c["messages"]);
    }
  }
  CHECK(cases > 80);
}

namespace {

/** Whether the stream ends with the last frame delivered: then its bytes are those of an intact stream. */
bool readsAsIntact(const json &messages, const std::string &stream) {
  if (messages.empty() || messages.back()["version"] != 1)
    return false;
  size_t length = 6 + messages.back()["hex"].get<std::string>().size() / 2;
  return stream.size() >= length && stream.compare(stream.size() - length, 4, "fffe") == 0;
}

}  // namespace

TEST_CASE("a frame after any damage to the frame before it is never lost") {
  int ambiguous = 0;
  std::mt19937 random(1);
  const std::string damaged[] = {frame1("speed(120)"), frame1(frame1("a") + "fff"), frame2("speed(120)", 2, 7), frame2(frame1("x"), 2, 7)};
  const std::string next[] = {frame1("stop"), frame2("stop", 2, 8)};
  const json expected[] = {{{"version", 1}, {"hex", hexOf("stop")}},
                           {{"version", 2}, {"hex", hexOf("stop")}, {"flags", 2}, {"sequence", 8}}};
  for (const std::string &original : damaged)
    for (int version = 0; version < 2; version++)
      for (uint16_t gap : {0, 200})
        for (int round = 0; round < 3000; round++) {
          std::string bytes = original;
          size_t at = random() % bytes.size();
          switch (round % 4) {
          case 0: bytes[at] = static_cast<char>(random()); break;
          case 1: bytes.erase(at, 1); break;
          case 2: bytes.insert(at, 1, static_cast<char>(random())); break;
          default: bytes.resize(at);
          }
          Receiver receiver;
          receiver.receive(bytes, 0);
          receiver.receive(next[version], gap);
          receiver.idle(gap + 101);
          INFO("damaged: ", bytes);
          bool found = std::find(receiver.messages.begin(), receiver.messages.end(), expected[version]) != receiver.messages.end();
          if (!found && gap == 0 && readsAsIntact(receiver.messages, bytes + next[version]))
            ambiguous++;
          else
            REQUIRE(found);
        }
  CHECK(ambiguous < 500);
  printf("  frames right behind 48,000 damaged ones: none lost but %d where the damage reads as an intact stream\n", ambiguous);
}

TEST_CASE("an intact stream of nasty payloads yields exactly its frames") {
  std::mt19937 random(2);
  const std::string alphabet = "fffffeeed0123459AFxy;";
  for (int round = 0; round < 5000; round++) {
    Receiver receiver;
    json expected = json::array();
    std::string stream;
    for (int i = 0; i < 5; i++) {
      std::string payload;
      for (size_t n = random() % 30; n > 0; n--)
        payload += alphabet[random() % alphabet.size()];
      bool two = random() % 2;
      stream += two ? frame2(payload, 2, i) : frame1(payload);
      json message = {{"version", two ? 2 : 1}, {"hex", hexOf(payload)}};
      if (two) {
        message["flags"] = 2;
        message["sequence"] = i;
      }
      expected.push_back(message);
    }
    receiver.receive(stream, 0);
    receiver.idle(101);
    INFO(stream);
    REQUIRE(receiver.messages == expected);
  }
}

TEST_CASE("ten million random bytes do no harm and leave the decoder able to read the next frame") {
  const long total = 10000000;
  std::mt19937 random(3);
  const std::string likely = "ffffffeedd00112348AFaf";
  std::vector<uint8_t> memory(JAVINO_WINDOW);
  javino_decoder decoder;
  javino_decoder_init(&decoder, memory.data(), JAVINO_WINDOW, 100);
  javino_frame frame;
  uint16_t now = 0;
  unsigned sum = 0;
  for (long i = 0; i < total; i++) {
    // Half of them make headers likely; silences fall anywhere.
    unsigned r = static_cast<unsigned>(random());
    uint8_t byte = r & 1 ? static_cast<uint8_t>(r >> 8) : static_cast<uint8_t>(likely[(r >> 8) % likely.size()]);
    if (r >> 24 == 0)
      now = static_cast<uint16_t>(now + (r >> 8) % 300);
    REQUIRE(javino_decoder_ready(&decoder));
    javino_decoder_put(&decoder, byte, now);
    while (javino_decoder_next(&decoder, now, &frame))
      for (int k = 0; k < frame.length; k++)
        sum += frame.payload[k];
  }
  printf("  %ld random bytes under the sanitizers (sum of what was delivered: %u)\n", total, sum);
  while (javino_decoder_next(&decoder, static_cast<uint16_t>(now + 200), &frame)) {
  }
  for (unsigned char byte : frame1("hello")) {
    REQUIRE(javino_decoder_ready(&decoder));
    javino_decoder_put(&decoder, byte, static_cast<uint16_t>(now + 200));
  }
  REQUIRE(javino_decoder_next(&decoder, static_cast<uint16_t>(now + 200), &frame));
  CHECK(std::string(reinterpret_cast<const char *>(frame.payload), frame.length) == "hello");
}

TEST_CASE("bytes that wait while a frame is in hand are read afterwards, with the silence between them") {
  Receiver receiver;
  javino_frame frame;
  std::string cut = frame1("never whole");
  auto put = [&](const std::string &bytes, uint16_t now) {
    javino_decoder_idle(&receiver.decoder, now);
    for (unsigned char byte : bytes) {
      REQUIRE(javino_decoder_ready(&receiver.decoder));
      javino_decoder_put(&receiver.decoder, byte, now);
    }
  };
  put(frame1("in hand"), 0);
  REQUIRE(javino_decoder_next(&receiver.decoder, 0, &frame));
  const uint8_t *payload = frame.payload;
  put(cut.substr(0, 8), 1);
  put(frame1("after"), 200);
  CHECK(std::string(reinterpret_cast<const char *>(payload), frame.length) == "in hand");
  REQUIRE(javino_decoder_next(&receiver.decoder, 200, &frame));
  CHECK(std::string(reinterpret_cast<const char *>(frame.payload), frame.length) == "after");
}

TEST_CASE("a decoder with less memory reads what fits and passes over what does not") {
  for (uint16_t size : {20, 40, 100}) {
    std::vector<uint8_t> memory(size);
    javino_decoder decoder;
    javino_decoder_init(&decoder, memory.data(), size, 100);
    std::string stream = frame1(std::string(200, 'x')) + frame1("hello");
    javino_frame frame;
    int found = 0;
    for (unsigned char byte : stream) {
      REQUIRE(javino_decoder_ready(&decoder));
      javino_decoder_put(&decoder, byte, 0);
      while (javino_decoder_next(&decoder, 0, &frame)) {
        CHECK(frame.length == 5);
        found++;
      }
    }
    CHECK(found == 1);
  }
}

TEST_CASE("asking what follows without a frame in hand changes nothing") {
  // The CRC is F8C6; its first digits stand there twice.
  Receiver receiver;
  for (unsigned char byte : std::string("fffd0548ledOn8"))
    javino_decoder_put(&receiver.decoder, byte, 0);
  CHECK(javino_decoder_follows(&receiver.decoder, 0) == JAVINO_FOLLOWS_UNKNOWN);
  receiver.receive("C6F8C6", 0);
  receiver.idle(101);
  CHECK(receiver.messages.empty());
}

TEST_CASE("a call reads a bounded number of bytes, and the next goes on") {
  std::string nasty;
  while (nasty.size() < 1000)
    nasty += "fffd8012";
  std::vector<uint8_t> memory(1500);
  javino_decoder decoder;
  javino_frame frame;
  javino_decoder_init(&decoder, memory.data(), static_cast<uint16_t>(memory.size()), 100);
  for (unsigned char byte : nasty + frame2("hello", 0, 1))
    javino_decoder_put(&decoder, byte, 0);
  // A hundred headers, and behind each 140 bytes of which the last digits are wrong.
  int calls = 1;
  while (!javino_decoder_next(&decoder, 101, &frame) && calls < 100)
    calls++;
  CHECK(calls > 10);
  CHECK(calls < 20);
  CHECK(std::string(reinterpret_cast<const char *>(frame.payload), frame.length) == "hello");
}

TEST_CASE("what cannot be whole before a silence is not read again and again") {
  std::string nasty;
  while (nasty.size() < 268)
    nasty += "fffeFF";
  Receiver receiver;
  receiver.receive(nasty.substr(0, 260), 0);
  javino_decoder_idle(&receiver.decoder, 101);
  for (unsigned char byte : frame1("hi"))
    javino_decoder_put(&receiver.decoder, byte, 101);
  javino_frame frame;
  // One call is enough.
  REQUIRE(javino_decoder_next(&receiver.decoder, 101, &frame));
  CHECK(frame.length == 2);
}

TEST_CASE("a decoder that could not hold any frame says so") {
  uint8_t memory[12];
  javino_decoder decoder;
  CHECK(!javino_decoder_init(&decoder, memory, 0, 100));
  CHECK(!javino_decoder_init(&decoder, memory, 11, 100));
  CHECK(javino_decoder_init(&decoder, memory, 12, 100));
}

TEST_CASE("silence is 20 byte times or 100 ms") {
  CHECK(JAVINO_TIMEOUT_MS(115200) == 100);
  CHECK(JAVINO_TIMEOUT_MS(9600) == 100);
  CHECK(JAVINO_TIMEOUT_MS(1200) == 166);
  CHECK(JAVINO_TIMEOUT_MS(300) == 666);
}
