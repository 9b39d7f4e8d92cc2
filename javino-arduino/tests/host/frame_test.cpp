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

const json &vectors() {
  static const json all = json::parse(std::ifstream(VECTORS));
  return all;
}

const json &vectors2() {
  static const json all = json::parse(std::ifstream(VECTORS_2));
  return all;
}

/** A frame that was received. */
struct Received {
  const uint8_t *payload = nullptr;
  uint8_t length = 0, version = 0, kind = 0, number = 0;
};

bool receiveNext(javino_decoder *decoder, uint16_t now, Received *frame) {
  const uint8_t *bytes = javino_decoder_next(decoder, now);
  if (!bytes)
    return false;
  *frame = Received();
  frame->version = *bytes == JAVINO_START ? 2 : 1;
  frame->length = static_cast<uint8_t>(decoder->taken - JAVINO_OVERHEAD);
  frame->payload = bytes + (frame->version == 2 ? JAVINO_PAYLOAD_AT : JAVINO_PAYLOAD_AT_1);
  if (frame->version == 2) {
    CHECK(bytes[JAVINO_LENGTH_AT] == frame->length);
    frame->kind = bytes[JAVINO_KIND_AT];
    frame->number = bytes[JAVINO_NUMBER_AT];
  }
  return true;
}

/** A frame as the vectors have it: of version 2 CC SS payload, of version 1 its text. */
std::string hexOfFrame(const Received &frame) {
  std::string payload(reinterpret_cast<const char *>(frame.payload), frame.length);
  return frame.version == 2 ? hexOf(std::string{octet(frame.kind), octet(frame.number)} + payload) : hexOf(payload);
}

/** A decoder with exactly the memory it asks for, so that the sanitizer sees every byte too far. */
struct Receiver {
  std::vector<uint8_t> memory = std::vector<uint8_t>(JAVINO_WINDOW);
  javino_decoder decoder;
  json messages = json::array(); /* of version 1 */
  json frames = json::array();   /* of version 2 */

  explicit Receiver(uint16_t timeout = 100, uint8_t nonce = 0) {
    javino_decoder_init(&decoder, memory.data(), JAVINO_WINDOW, timeout);
    if (nonce)
      javino_decoder_session(&decoder, nonce);
  }

  void idle(uint16_t now) {
    Received frame;
    while (receiveNext(&decoder, now, &frame))
      (frame.version == 2 ? frames : messages).push_back(hexOfFrame(frame));
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

/** Returns true if a case of the vectors is only for version 1. */
bool isVersion1(const json &c) {
  return c.contains("receivers") ? c["receivers"][0] == json{1} : c.value("version", 1) == 1;
}

void collect(void *text, uint8_t byte) {
  *static_cast<std::string *>(text) += static_cast<char>(byte);
}

}  // namespace

TEST_CASE("the checksum is that of the vectors") {
  for (const json &c : vectors()["crc"]) {
    INFO(c["name"]);
    uint16_t crc = JAVINO_CRC_START(0);
    for (unsigned char byte : bytesOf(c["hex"]))
      crc = javino_crc16(crc, byte);
    CHECK(::hexOf(crc, 4) == c["crc"]);
  }
}

TEST_CASE("frames are written as in the vectors") {
  for (const json &c : vectors()["encode"]) {
    if (!isVersion1(c))
      continue;
    INFO(c["name"]);
    std::string out;
    std::string payload = bytesOf(c["hex"]);
    javino_encoder encoder = {collect, &out, 0, false};
    javino_encoder_begin(&encoder, static_cast<uint8_t>(payload.size()));
    for (unsigned char byte : payload)
      javino_encoder_put(&encoder, byte);
    javino_encoder_end(&encoder);
    CHECK(hexOf(out) == c["frame"]);
  }
  for (const json &c : vectors2()["frames"]) {
    INFO(c["name"]);
    std::string out;
    std::string payload = bytesOf(c["payloadHex"]);
    uint8_t kind = static_cast<uint8_t>(bytesOf(c["kind"])[0]);
    javino_encoder encoder = {collect, &out, 0, false};
    const uint8_t nonce = beginsSessions(kind) ? 0 : c["nonce"].get<uint8_t>();
    javino_encoder_begin2(&encoder, nonce, kind, c["number"], static_cast<uint8_t>(payload.size()));
    for (unsigned char byte : payload)
      javino_encoder_put(&encoder, byte);
    javino_encoder_end(&encoder);
    CHECK(hexOf(out) == c["frameHex"]);
    CHECK(out == frame2(kind, c["number"], payload, nonce));
  }
}

TEST_CASE("what arrives is read as in the vectors of version 1") {
  int cases = 0;
  for (const json &c : vectors()["decode"]) {
    if (!isVersion1(c))
      continue;
    cases++;
    // The clock starts anywhere, so that it also wraps around.
    for (uint16_t start : {0, 12345, 65500}) {
      INFO(c["name"]);
      json expected = json::array();
      for (const json &message : c["messages"])
        expected.push_back(message.is_object() ? message["hex"] : message);
      Receiver receiver(c["timeoutMs"]);
      uint16_t now = start;
      for (const json &chunk : c["chunks"]) {
        now = static_cast<uint16_t>(now + chunk["gapMs"].get<int>());
        receiver.receive(bytesOf(chunk["hex"]), now);
        if (chunk.contains("delivered"))
          CHECK(receiver.messages.size() == chunk["delivered"]);
      }
      receiver.idle(static_cast<uint16_t>(now + c["endGapMs"].get<int>()));
      CHECK(receiver.messages == expected);
    }
  }
  CHECK(cases > 60);
}

TEST_CASE("what arrives is read as in the vectors of version 2") {
  int cases = 0;
  for (const json &c : vectors2()["receive"]) {
    if (c["direction"] != "to-board")
      continue;
    cases++;
    for (uint16_t start : {0, 12345, 65400}) {
      INFO(c["name"]);
      Receiver receiver(100, c["session"]);
      uint16_t now = start;
      for (const json &chunk : c["chunks"]) {
        now = static_cast<uint16_t>(now + chunk["gapMs"].get<int>());
        receiver.receive(bytesOf(chunk["hex"]), now);
      }
      receiver.idle(static_cast<uint16_t>(now + 200));
      receiver.idle(static_cast<uint16_t>(now + 201));
      CHECK(receiver.frames == c["frames"]);
      json messages = json::array();
      for (const json &text : c["version1"])
        messages.push_back(hexOf(latin1(text)));
      CHECK(receiver.messages == messages);
    }
  }
  CHECK(cases > 40);
}

namespace {

/** Returns true if the stream ends with the last message delivered: then its bytes are those of an intact stream. */
bool readsAsIntact(const json &messages, const std::string &stream) {
  if (messages.empty())
    return false;
  size_t length = 6 + messages.back().get<std::string>().size() / 2;
  return stream.size() >= length && stream.compare(stream.size() - length, 4, "fffe") == 0;
}

bool holds(const json &list, const std::string &hex) {
  return std::find(list.begin(), list.end(), json(hex)) != list.end();
}

/** Changes, removes or inserts one byte, or cuts the rest off. */
void damage(std::string &bytes, std::mt19937 &random, int kind) {
  size_t at = random() % bytes.size();
  switch (kind % 4) {
  case 0: bytes[at] = static_cast<char>(random()); break;
  case 1: bytes.erase(at, 1); break;
  case 2: bytes.insert(at, 1, static_cast<char>(random())); break;
  default: bytes.resize(at);
  }
}

}  // namespace

TEST_CASE("a frame behind damage is never lost: of version 2 behind any, of version 1 behind its own or a silence") {
  int ambiguous = 0;
  std::mt19937 random(1);
  const std::string damaged[] = {frame1("speed(120)"), frame1(frame1("a") + "fff"), command(7, "speed(120)"),
                                 command(7, frame1("x") + "\xA5\xA4")};
  for (int first = 0; first < 4; first++)
    for (int version = 1; version <= 2; version++)
      for (uint16_t gap : {0, 200})
        for (int round = 0; round < 3000; round++) {
          if (first >= 2 && version == 1 && gap == 0)
            continue;
          std::string bytes = damaged[first];
          damage(bytes, random, round);
          // The start of version 2 takes what follows it, which is not read twice.
          if (first < 2 && version == 1 && bytes.find('\xA5') != std::string::npos)
            continue;
          const std::string next = version == 1 ? frame1("stop") : command(8, "stop");
          Receiver receiver;
          receiver.receive(bytes, 0);
          receiver.receive(next, gap);
          receiver.idle(gap + 101);
          INFO("damaged: ", bytes);
          bool found = version == 1 ? holds(receiver.messages, hexOf("stop")) : holds(receiver.frames, "3008" + hexOf(item("stop")));
          if (!found && gap == 0 && readsAsIntact(receiver.messages, bytes + next))
            ambiguous++;
          else
            REQUIRE(found);
        }
  CHECK(ambiguous < 500);
  printf("  frames right behind 36,000 damaged ones: none lost but %d where the damage reads as an intact stream\n", ambiguous);
}

TEST_CASE("an intact stream of nasty payloads yields exactly its frames") {
  std::mt19937 random(2);
  const std::string alphabet = "fffffeeed0123459AFxy;\xA4\xA5\x04\x05";
  for (int round = 0; round < 5000; round++) {
    Receiver receiver;
    json messages = json::array(), frames = json::array();
    std::string stream;
    for (unsigned i = 0; i < 5; i++) {
      std::string payload;
      for (size_t n = random() % 30; n > 0; n--)
        payload += alphabet[random() % alphabet.size()];
      if (random() % 2) {
        stream += frame2(0x30, 0xA0 + i, payload);
        frames.push_back(hexOf(std::string{octet(0x30), octet(0xA0 + i)} + payload));
      } else {
        stream += frame1(payload);
        messages.push_back(hexOf(payload));
      }
    }
    receiver.receive(stream, 0);
    receiver.idle(101);
    INFO(stream);
    REQUIRE(receiver.messages == messages);
    REQUIRE(receiver.frames == frames);
  }
}

TEST_CASE("every single damage to a frame of version 2 is found, and in a session nothing inside it counts") {
  const std::string inside[] = {"front", frame1("front"), frame1("x") + frame1("front"), "\xA5\xA4" + command(5, "front"),
                                "fffeFF" + frame1("front")};
  for (const std::string &text : inside) {
    const std::string whole = command(4, "say(\"" + text + "\")");
    for (size_t at = 0; at < whole.size(); at++)
      for (int damage = 0; damage < 8 + 3; damage++) {
        std::string damaged = whole;
        if (damage < 8)
          damaged[at] = static_cast<char>(damaged[at] ^ (1 << damage));
        else if (damage == 8)
          damaged.erase(at, 1);
        else if (damage == 9)
          damaged.insert(at, "0");
        else
          damaged.resize(at);
        // The rest of a whole frame would be a frame.
        if (damaged.find(whole) != std::string::npos)
          continue;
        Receiver receiver(100, session);
        receiver.receive(damaged, 0);
        receiver.receive(hello(), 0);
        receiver.idle(101);
        INFO(hexOf(damaged));
        REQUIRE(receiver.frames == json{"1007"});
        REQUIRE(receiver.messages.empty());
      }
  }
}

TEST_CASE("ten million random bytes do no harm and leave the decoder able to read the next frame") {
  const long total = 10000000;
  std::mt19937 random(3);
  const std::string likely = "ffffffeedd00112348AFaf\xA5\xA5\xA4\x30\x20\x04";
  std::vector<uint8_t> memory(JAVINO_WINDOW);
  javino_decoder decoder;
  javino_decoder_init(&decoder, memory.data(), JAVINO_WINDOW, 100);
  Received frame;
  uint16_t now = 0;
  unsigned sum = 0;
  for (long i = 0; i < total; i++) {
    // Half of them make headers likely; silences fall anywhere.
    unsigned r = static_cast<unsigned>(random());
    uint8_t byte = r & 1 ? static_cast<uint8_t>(r >> 8) : static_cast<uint8_t>(likely[(r >> 8) % likely.size()]);
    if (r >> 24 == 0)
      now = static_cast<uint16_t>(now + (r >> 8) % 300);
    if (!javino_decoder_ready(&decoder))
      FAIL("no room for byte ", i); // REQUIRE takes longer than the decoder for each byte
    javino_decoder_put(&decoder, byte, now);
    while (receiveNext(&decoder, now, &frame))
      for (int k = 0; k < frame.length; k++)
        sum += frame.payload[k];
  }
  printf("  %ld random bytes under the sanitizers (sum of what was delivered: %u)\n", total, sum);
  while (receiveNext(&decoder, static_cast<uint16_t>(now + 200), &frame)) {
  }
  for (unsigned char byte : frame1("hello")) {
    REQUIRE(javino_decoder_ready(&decoder));
    javino_decoder_put(&decoder, byte, static_cast<uint16_t>(now + 200));
  }
  REQUIRE(receiveNext(&decoder, static_cast<uint16_t>(now + 200), &frame));
  CHECK(std::string(reinterpret_cast<const char *>(frame.payload), frame.length) == "hello");
}

TEST_CASE("bytes that wait while a frame is in hand are read afterwards, with the silence between them") {
  Receiver receiver;
  Received frame;
  std::string cut = frame1("never whole");
  auto put = [&](const std::string &bytes, uint16_t now) {
    javino_decoder_idle(&receiver.decoder, now);
    for (unsigned char byte : bytes) {
      REQUIRE(javino_decoder_ready(&receiver.decoder));
      javino_decoder_put(&receiver.decoder, byte, now);
    }
  };
  put(frame1("in hand"), 0);
  REQUIRE(receiveNext(&receiver.decoder, 0, &frame));
  const uint8_t *payload = frame.payload;
  put(cut.substr(0, 8), 1);
  put(frame1("after"), 200);
  CHECK(std::string(reinterpret_cast<const char *>(payload), frame.length) == "in hand");
  REQUIRE(receiveNext(&receiver.decoder, 200, &frame));
  CHECK(std::string(reinterpret_cast<const char *>(frame.payload), frame.length) == "after");
}

TEST_CASE("a decoder with less memory reads what fits and passes over what does not") {
  for (uint16_t size : {20, 40, 100}) {
    std::vector<uint8_t> memory(size);
    javino_decoder decoder;
    javino_decoder_init(&decoder, memory.data(), size, 100);
    std::string stream = frame1(std::string(200, 'x')) + frame1("hello");
    Received frame;
    int found = 0;
    for (unsigned char byte : stream) {
      REQUIRE(javino_decoder_ready(&decoder));
      javino_decoder_put(&decoder, byte, 0);
      while (receiveNext(&decoder, 0, &frame)) {
        CHECK(frame.length == 5);
        found++;
      }
    }
    CHECK(found == 1);
  }
}

TEST_CASE("a frame of version 2 that is longer than the memory is dropped, and the next one is read") {
  std::vector<uint8_t> memory(100);
  javino_decoder decoder;
  javino_decoder_init(&decoder, memory.data(), 100, 100);
  Received frame;
  for (size_t length : {93, 94}) {
    bool found = false;
    for (unsigned char byte : frame2(0x30, 0xA5, std::string(length, '\xA4')) + hello(9)) {
      REQUIRE(javino_decoder_ready(&decoder));
      javino_decoder_put(&decoder, byte, 0);
      if (receiveNext(&decoder, 0, &frame))
        found |= frame.length == length;
    }
    CHECK(found == (length == 93));
    CHECK(frame.kind == JAVINO_HELLO);
  }
}

TEST_CASE("bytes of version 2 that were not looked at for long are read all at once") {
  std::vector<uint8_t> memory(JAVINO_WINDOW);
  javino_decoder decoder;
  javino_decoder_init(&decoder, memory.data(), JAVINO_WINDOW, 100);
  Received frame;
  std::string waits = command(0, "\xA5\xA4") + command(1, std::string(60, '\xA5')) + "noise\xA5" + hello();
  for (unsigned char byte : waits) {
    REQUIRE(javino_decoder_ready(&decoder));
    javino_decoder_put(&decoder, byte, 0);
  }
  std::vector<int> lengths;
  while (receiveNext(&decoder, 0, &frame))
    lengths.push_back(frame.length);
  CHECK(lengths == std::vector<int>{3, 61, 0});
}

TEST_CASE("asking what follows without a frame in hand changes nothing") {
  Receiver receiver;
  for (unsigned char byte : std::string("fffe05led"))
    javino_decoder_put(&receiver.decoder, byte, 0);
  CHECK(javino_decoder_follows(&receiver.decoder, 0) == JAVINO_FOLLOWS_UNKNOWN);
  receiver.receive("On", 0);
  receiver.idle(101);
  CHECK(receiver.messages == json{hexOf("ledOn")});
}

TEST_CASE("headers in payloads that nothing confirms are each read again, and a frame behind them is found") {
  std::string nasty;
  while (nasty.size() < 1000)
    nasty += "fffeF0fffe8012";
  std::vector<uint8_t> memory(1500);
  javino_decoder decoder;
  Received frame;
  javino_decoder_init(&decoder, memory.data(), static_cast<uint16_t>(memory.size()), 100);
  for (unsigned char byte : nasty + frame1("hello"))
    javino_decoder_put(&decoder, byte, 0);
  // Seventy headers, each of a message behind which there is no header, so that it is read again.
  int found = 0;
  while (found < 1000 && receiveNext(&decoder, 101, &frame) && frame.length != 5)
    found++;
  CHECK(found > 0);
  CHECK(found < 1000);
  CHECK(std::string(reinterpret_cast<const char *>(frame.payload), frame.length) == "hello");
}

TEST_CASE("what cannot be whole before a silence is not read again and again") {
  std::string nasty;
  while (nasty.size() < 268)
    nasty += "fffeFF";
  Receiver receiver;
  receiver.receive(nasty.substr(0, 252), 0);
  javino_decoder_idle(&receiver.decoder, 101);
  for (unsigned char byte : frame1("hi"))
    javino_decoder_put(&receiver.decoder, byte, 101);
  Received frame;
  // One call is enough.
  REQUIRE(receiveNext(&receiver.decoder, 101, &frame));
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
