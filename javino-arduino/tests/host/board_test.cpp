// The conversation: requests, actions, acknowledgements, percepts, a lost link.

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include "frames.h"
#include "javino_board.h"
#include "javino_literal.h"

namespace {

/** A board with a far end that writes whole frames and keeps what comes back. */
struct Conversation {
  std::vector<uint8_t> memory;
  javino_board board;
  std::string out;
  std::string waiting; /* in the receive buffer */
  uint16_t now = 1000;

  explicit Conversation(uint16_t bytes = JAVINO_MEMORY + 255) : memory(bytes) {
    REQUIRE(javino_board_init(&board, memory.data(), bytes, write, this));
    poll();
  }

  static void write(void *self, uint8_t byte) { static_cast<Conversation *>(self)->out += static_cast<char>(byte); }

  /** What arrives while the program polls often. */
  void receive(const std::string &bytes) {
    javino_decoder_idle(&board.link.decoder, now);
    find(bytes);
  }

  /** What has waited in the receive buffer when the program comes to look into it. */
  void find(const std::string &bytes) {
    waiting += bytes;
    size_t n = 0;
    for (; n < waiting.size() && javino_link_ready(&board.link); n++)
      javino_link_receive(&board.link, static_cast<uint8_t>(waiting[n]), now);
    waiting.erase(0, n);
  }

  javino_event poll() {
    find("");
    return javino_board_poll(&board, now);
  }

  javino_event hear(const std::string &bytes) {
    receive(bytes);
    javino_event event = poll();
    while (event == JAVINO_NOTHING && !waiting.empty())
      event = poll();
    return event;
  }

  std::string text() const {
    return std::string(reinterpret_cast<const char *>(board.link.frame.payload), board.link.frame.length);
  }

  std::string sent() {
    std::string bytes;
    bytes.swap(out);
    return bytes;
  }

  bool percept(const std::string &text) {
    for (char c : text)
      javino_percept_put(&board, c);
    return javino_percept_end(&board);
  }
};

/** The payloads of version 1 frames that follow each other; the test fails if the bytes are anything else. */
std::vector<std::string> payloads1(const std::string &bytes) {
  std::vector<std::string> found;
  size_t at = 0;
  while (at < bytes.size()) {
    REQUIRE(bytes.compare(at, 4, "fffe") == 0);
    size_t length = std::stoul(bytes.substr(at + 4, 2), nullptr, 16);
    REQUIRE(at + 6 + length <= bytes.size());
    found.push_back(bytes.substr(at + 6, length));
    at += 6 + length;
  }
  return found;
}

/** The message that version 2 fragments make; the first has this sequence number. */
std::string message2(const std::string &bytes, unsigned sequence) {
  std::string message;
  size_t at = 0;
  bool more = true;
  while (more) {
    REQUIRE(at + 12 <= bytes.size());
    REQUIRE(bytes.compare(at, 4, "fffd") == 0);
    size_t length = std::stoul(bytes.substr(at + 4, 2), nullptr, 16);
    unsigned flags = static_cast<unsigned>(std::stoul(bytes.substr(at + 6, 1), nullptr, 16));
    std::string payload = bytes.substr(at + 8, length);
    REQUIRE(bytes.substr(at, 12 + length) == frame2(payload, flags, sequence));
    message += payload;
    more = flags & 1;
    sequence = (sequence + 1) & 15;
    at += 12 + length;
  }
  REQUIRE(at == bytes.size());
  return message;
}

}  // namespace

TEST_CASE("a request is answered in the version it was made in") {
  Conversation c;
  CHECK(c.hear(frame1("getPercepts")) == JAVINO_REQUEST);
  c.percept("dist(f,10)");
  javino_board_answer(&c.board);
  CHECK(c.sent() == frame1("dist(f,10);"));
  CHECK(c.hear(frame2("getPercepts", 0, 5)) == JAVINO_REQUEST);
  c.percept("dist(f,11)");
  c.percept("light(b,40)");
  javino_board_answer(&c.board);
  CHECK(message2(c.sent(), 1) == "dist(f,11);light(b,40);");
  CHECK(c.hear(frame1("getPercepts")) == JAVINO_REQUEST);
  javino_board_answer(&c.board);
  CHECK(c.sent() == frame1(""));
}

TEST_CASE("only getPercepts and getPercepts(...) are requests") {
  Conversation c;
  CHECK(c.hear(frame1("getPerceptsNow")) == JAVINO_ACTION);
  CHECK(c.hear(frame1("getPercept")) == JAVINO_ACTION);
  CHECK(c.hear(frame1("getPercepts(dist)")) == JAVINO_REQUEST);
}

TEST_CASE("a command and a request in one burst are both handled, in order") {
  Conversation c;
  c.receive(frame1("ledOn") + frame1("getPercepts") + frame2("stop", 2, 1));
  CHECK(c.poll() == JAVINO_ACTION);
  CHECK(c.text() == "ledOn");
  CHECK(c.poll() == JAVINO_REQUEST);
  CHECK(c.poll() == JAVINO_ACTION);
  CHECK(c.text() == "stop");
  CHECK(c.poll() == JAVINO_NOTHING);
}

TEST_CASE("version 1 is never acknowledged") {
  Conversation c;
  CHECK(c.hear(frame1("ledOn")) == JAVINO_ACTION);
  javino_link_finish(&c.board.link, true);
  CHECK(c.hear(frame1("nonsense")) == JAVINO_ACTION);
  javino_link_finish(&c.board.link, false);
  c.poll();
  CHECK(c.sent() == "");
}

TEST_CASE("a version 2 action is acknowledged when it has been carried out, with its own sequence number") {
  Conversation c;
  CHECK(c.hear(frame2("ledOn", 2, 9)) == JAVINO_ACTION);
  CHECK(c.sent() == "");
  javino_link_finish(&c.board.link, true);
  CHECK(c.sent() == frame2("", 4, 9));
  c.poll();
  CHECK(c.sent() == "");
}

TEST_CASE("an action that is not finished counts as carried out with the next poll") {
  Conversation c;
  c.hear(frame2("ledOn", 2, 9));
  c.poll();
  CHECK(c.sent() == frame2("", 4, 9));
}

TEST_CASE("an unknown action is refused") {
  Conversation c;
  c.hear(frame2("fly", 2, 15));
  javino_link_finish(&c.board.link, false);
  CHECK(c.sent() == frame2("", 8, 15));
}

TEST_CASE("an action that wants no acknowledgement gets none") {
  Conversation c;
  c.hear(frame2("ledOn", 0, 9));
  c.poll();
  CHECK(c.sent() == "");
}

TEST_CASE("a repeated action is answered as before and not handed out again") {
  for (bool done : {true, false}) {
    Conversation c;
    c.hear(frame2("toggle", 2, 4));
    javino_link_finish(&c.board.link, done);
    std::string answer = c.sent();
    for (int repeat = 0; repeat < 3; repeat++) {
      c.now += 500;
      CHECK(c.hear(frame2("toggle", 2, 4)) == JAVINO_NOTHING);
      CHECK(c.sent() == answer);
    }
  }
}

TEST_CASE("requests between an action and its repetition do not make it new") {
  Conversation c;
  c.hear(frame2("toggle", 2, 4));
  c.poll();
  for (unsigned i = 5; i < 25; i++) {
    c.now += 20;
    CHECK(c.hear(frame2("getPercepts", 0, i & 15)) == JAVINO_REQUEST);
  }
  c.sent();
  CHECK(c.hear(frame2("toggle", 2, 4)) == JAVINO_NOTHING);
  CHECK(c.sent() == frame2("", 4, 4));
}

TEST_CASE("the same action with the next sequence number is new") {
  Conversation c;
  c.hear(frame2("toggle", 2, 4));
  CHECK(c.hear(frame2("toggle", 2, 5)) == JAVINO_ACTION);
}

TEST_CASE("another action with the same sequence number is new: the far end was started anew") {
  Conversation c;
  c.hear(frame2("ledOn", 2, 0));
  CHECK(c.hear(frame2("ledOff", 2, 0)) == JAVINO_ACTION);
}

TEST_CASE("an action of any length is carried out once whatever the time of the caller's clock") {
  // What the far end repeats while the action runs waits in the receive buffer.
  const std::string action = frame2("toggle", 2, 4);
  for (unsigned took : {0, 500, 3200, 10000}) {
    SUBCASE("one time for each turn of the main loop, read at its beginning") {
      Conversation c;
      c.find(action);
      CHECK(c.poll() == JAVINO_ACTION);
      javino_link_finish(&c.board.link, true);
      c.now = static_cast<uint16_t>(c.now + took);
      for (int repeat = 0; repeat < 3; repeat++)
        c.find(action);
      CHECK(c.poll() == JAVINO_NOTHING);
    }
    SUBCASE("a time that was read before the action, until nothing is left") {
      Conversation c;
      c.find(action);
      CHECK(c.poll() == JAVINO_ACTION);
      CHECK(c.poll() == JAVINO_NOTHING);
      c.now = static_cast<uint16_t>(c.now + took);
      for (int repeat = 0; repeat < 3; repeat++)
        c.find(action);
      CHECK(c.poll() == JAVINO_NOTHING);
    }
  }
}

TEST_CASE("a repetition that has waited while the program was busy is one") {
  for (unsigned busy : {2000, 3100, 20000}) {
    Conversation c;
    c.hear(frame2("toggle", 2, 4));
    c.poll();
    c.sent();
    c.now = static_cast<uint16_t>(c.now + busy);
    c.find(frame2("getPercepts", 0, 1) + frame2("toggle", 2, 4));
    CHECK(c.poll() == JAVINO_REQUEST);
    CHECK(c.poll() == JAVINO_NOTHING);
    CHECK(c.sent() == frame2("", 4, 4));
  }
}

TEST_CASE("a repetition waits outside while there is no room for it") {
  Conversation c(JAVINO_MEMORY);
  c.hear(frame2("toggle", 2, 4));
  c.poll();
  c.sent();
  // A long message is in hand and what follows fills the memory; the repetition is still in the receive buffer.
  c.find(frame2("getPercepts(" + std::string(230, 'x') + ")", 0, 1) + frame2("", 4, 2) + frame2("", 4, 3) + frame2("toggle", 2, 4));
  CHECK(c.poll() == JAVINO_REQUEST);
  c.find("");
  REQUIRE(!c.waiting.empty());
  c.now += 3500;
  for (int i = 0; i < 5; i++)
    CHECK(c.poll() == JAVINO_NOTHING);
  CHECK(c.sent() == frame2("", 4, 4));
}

TEST_CASE("bytes that waited while the program was busy are not late") {
  for (uint16_t busy : {101, 150, 300, 1000}) {
    for (const std::string &frame : {frame1("ledOn"), frame2("ledOn", 2, 1), frame2("getPercepts", 0, 1)}) {
      for (size_t cut = 1; cut < frame.size(); cut++) {
        Conversation c;
        c.find(frame.substr(0, cut));
        CHECK(c.poll() == JAVINO_NOTHING);
        c.now += busy;
        c.find(frame.substr(cut));
        CHECK(c.poll() != JAVINO_NOTHING);
      }
    }
  }
}

TEST_CASE("bytes that found no room are not late") {
  Conversation c(JAVINO_MEMORY_MIN);
  const std::string first = frame2("getPercepts(" + std::string(50, 'x') + ")", 0, 1);
  c.find(first + frame2("ledOn", 2, 2) + frame2("getPercepts", 0, 3));
  int found = 0;
  for (int turn = 0; turn < 12; turn++) {
    found += c.poll() != JAVINO_NOTHING;
    c.now += 300;
  }
  CHECK(found == 3);
}

TEST_CASE("an outcome that is reported later is not asked for twice") {
  for (bool done : {true, false}) {
    Conversation c;
    CHECK(c.hear(frame2("close", 2, 4)) == JAVINO_ACTION);
    javino_later later = javino_link_later(&c.board.link);
    REQUIRE(later != 0);
    javino_link_finish(&c.board.link, true);
    for (int i = 0; i < 20; i++) {
      c.now += 250;
      CHECK(c.hear(frame2("close", 2, 4)) == JAVINO_NOTHING);
      CHECK(c.hear(frame1("getPercepts")) == JAVINO_REQUEST);
      c.poll();
    }
    CHECK(c.sent() == "");
    CHECK(javino_link_done(&c.board.link, later, done));
    std::string answer = frame2("", done ? 4 : 8, 4);
    CHECK(c.sent() == answer);
    CHECK(!javino_link_done(&c.board.link, later, done));
    // From here on it is remembered as any other.
    CHECK(c.hear(frame2("close", 2, 4)) == JAVINO_NOTHING);
    CHECK(c.sent() == answer);
    for (int i = 0; i < 40; i++) {
      c.now += 100;
      c.poll();
    }
    CHECK(c.hear(frame2("close", 2, 4)) == JAVINO_ACTION);
  }
}

TEST_CASE("an outcome that nobody waits for any more is not reported") {
  Conversation c;
  CHECK(javino_link_later(&c.board.link) == 0);
  c.hear(frame1("close"));
  CHECK(javino_link_later(&c.board.link) == 0);
  CHECK(!javino_link_done(&c.board.link, 0, true));
  c.hear(frame2("close", 2, 4));
  javino_later first = javino_link_later(&c.board.link);
  c.hear(frame2("open", 2, 5));
  javino_later second = javino_link_later(&c.board.link);
  CHECK(!javino_link_done(&c.board.link, first, true));
  CHECK(c.sent() == "");
  CHECK(javino_link_done(&c.board.link, second, true));
  CHECK(c.sent() == frame2("", 4, 5));
}

TEST_CASE("long afterwards the same action with the same sequence number is new") {
  Conversation c;
  c.hear(frame2("toggle", 2, 4));
  c.poll();
  for (int i = 0; i < 40; i++) {
    c.now += 100;
    c.poll();
  }
  CHECK(c.hear(frame2("toggle", 2, 4)) == JAVINO_ACTION);
}

TEST_CASE("acknowledgements and refusals from the far end are no messages") {
  Conversation c;
  CHECK(c.hear(frame2("", 4, 1)) == JAVINO_NOTHING);
  CHECK(c.hear(frame2("ledOn", 8, 2)) == JAVINO_NOTHING);
  CHECK(c.sent() == "");
}

TEST_CASE("parts of a message to the board are refused and never taken for actions") {
  Conversation c;
  CHECK(c.hear(frame2("say(\"long\")", 3, 1)) == JAVINO_NOTHING);
  CHECK(c.sent() == frame2("", 8, 1));
  CHECK(c.hear(frame2("ledOn", 2, 2)) == JAVINO_NOTHING);
  CHECK(c.sent() == frame2("", 8, 2));
  CHECK(c.hear(frame2("ledOn", 2, 3)) == JAVINO_ACTION);
}

TEST_CASE("text that looks like a version 1 frame inside a damaged version 2 frame is no action") {
  std::string nasty = frame2("say(\"" + frame1("ledOn") + "\")", 2, 4);
  for (size_t at = 0; at < nasty.size(); at++) {
    Conversation c;
    c.hear(frame2("getPercepts", 0, 3));
    std::string damaged = nasty;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x40);
    c.receive(damaged);
    bool acted = false;
    for (int i = 0; i < 5; i++) {
      acted |= c.poll() == JAVINO_ACTION;
      c.now += 101;
    }
    INFO(damaged);
    CHECK(!acted);
  }
}

namespace {

/** Whether the board acts while these bytes arrive, all at once or byte by byte, and afterwards. */
bool acts(Conversation &c, const std::string &bytes) {
  bool acted = false;
  auto look = [&] {
    javino_event event;
    while ((event = c.poll()) != JAVINO_NOTHING)
      acted |= event == JAVINO_ACTION;
  };
  for (char byte : bytes) {
    c.receive(std::string(1, byte));
    look();
  }
  for (int i = 0; i < 5; i++) {
    c.now += 101;
    look();
  }
  return acted;
}

}  // namespace

TEST_CASE("no frame inside the text of a damaged version 2 command is carried out") {
  const std::string inside[] = {
      frame1("front"), frame2("front", 2, 5), frame1("x") + frame1("front"), frame2("getPercepts", 0, 1) + frame2("front", 2, 5),
      frame1("getPercepts") + frame1("getPercepts") + frame2("getPercepts", 0, 1) + frame2("front", 2, 5)};
  for (const std::string &text : inside) {
    const std::string whole = frame2("say(\"" + text + "\")", 2, 4);
    for (size_t at = 0; at < whole.size(); at++)
      for (int damage = 0; damage < 3; damage++) {
        std::string damaged = whole;
        if (damage == 0)
          damaged[at] = static_cast<char>(damaged[at] ^ 0x40);
        else if (damage == 1)
          damaged.erase(at, 1);
        else
          damaged.insert(at, "0");
        // What remains of a whole frame would be one.
        if (damaged.find(whole) != std::string::npos)
          continue;
        Conversation c;
        c.hear(frame2("getPercepts", 0, 3));
        c.poll();
        INFO(damaged);
        REQUIRE(!acts(c, damaged));
      }
  }
}

TEST_CASE("no frame inside a version 2 command that is longer than the memory is carried out") {
  for (const std::string &inside : {frame1("front"), frame2("front", 2, 5)}) {
    Conversation c(232);
    c.hear(frame2("getPercepts", 0, 3));
    c.poll();
    CHECK(!acts(c, frame2("say(\"" + std::string(210, 'x') + inside + "\")", 2, 4)));
    CHECK(c.sent().find(frame2("", 4, 5)) == std::string::npos);
    CHECK(acts(c, frame2("front", 2, 6)));
  }
}

TEST_CASE("behind damage a version 2 command is carried out after a pause of 26 ms, or behind 255 bytes of whole frames") {
  Conversation c;
  const std::string request = frame2("getPercepts", 0, 1);
  CHECK(acts(c, frame2("ledOn", 2, 1)));
  c.hear(request.substr(1));
  CHECK(c.hear(frame2("ledOn", 2, 2)) == JAVINO_NOTHING);
  c.now += 26;
  CHECK(c.hear(frame2("ledOn", 2, 2)) == JAVINO_ACTION);
  c.hear(request.substr(1));
  int requests = 0;
  while (c.hear(frame2("ledOn", 2, 3)) == JAVINO_NOTHING && requests < 100) {
    CHECK(c.hear(request) == JAVINO_REQUEST);
    requests++;
  }
  CHECK(requests == 7);
}

TEST_CASE("a part of a message whose last part is lost does not cost the next message") {
  Conversation c;
  CHECK(c.hear(frame2("say(\"long\")", 3, 1)) == JAVINO_NOTHING);
  CHECK(c.hear(frame2("getPercepts", 0, 5)) == JAVINO_REQUEST);
  CHECK(c.hear(frame2("say(\"long\")", 3, 1)) == JAVINO_NOTHING);
  CHECK(c.hear(frame2("ledOn", 2, 3)) == JAVINO_ACTION);
}

TEST_CASE("a repeated part of a message is refused again") {
  Conversation c;
  CHECK(c.hear(frame2("say(\"long", 3, 1)) == JAVINO_NOTHING);
  CHECK(c.hear(frame2("ledOn", 2, 2)) == JAVINO_NOTHING);
  c.sent();
  CHECK(c.hear(frame2("ledOn", 2, 2)) == JAVINO_NOTHING);
  CHECK(c.sent() == frame2("", 8, 2));
}

TEST_CASE("a version 1 action is carried out although version 2 was spoken before") {
  Conversation c;
  c.hear(frame2("getPercepts", 0, 3));
  CHECK(c.hear(frame1("ledOn")) == JAVINO_ACTION);
  c.now += 101;
  c.poll();
  CHECK(c.hear("noise") == JAVINO_NOTHING);
  CHECK(c.hear(frame1("ledOff")) == JAVINO_NOTHING);
  c.now += 101;
  CHECK(c.hear(frame1("ledOff")) == JAVINO_ACTION);
  c.receive("noise");
  c.now += 101;
  c.poll();
  CHECK(c.hear(frame1("ledOff")) == JAVINO_ACTION);
  CHECK(c.hear("\r\n") == JAVINO_NOTHING);
  c.now += 101;
  CHECK(c.hear(frame1("ledOff")) == JAVINO_ACTION);
}

TEST_CASE("a request that names functors is answered with those only") {
  Conversation c;
  c.hear(frame2("getPercepts(dist,light)", 0, 0));
  auto wants = [&](const std::string &functor) { return javino_board_wants(&c.board, functor.data(), functor.size()); };
  CHECK(wants("dist"));
  CHECK(wants("light"));
  CHECK(!wants("temp"));
  CHECK(!wants("dis"));
  CHECK(!wants("distance"));
  CHECK(!wants("ist"));
  CHECK(javino_percept_begin(&c.board, "dist"));
  javino_percept_text(&c.board, "(f,1)");
  javino_percept_end(&c.board);
  CHECK(!javino_percept_begin(&c.board, "temp"));
  javino_board_answer(&c.board);
  CHECK(message2(c.sent(), 0) == "dist(f,1);");
  c.hear(frame2("getPercepts", 0, 1));
  CHECK(wants("temp"));
  c.poll();
  CHECK(wants("temp"));
}

TEST_CASE("percepts too many for one frame: version 1 sends further messages of whole percepts") {
  for (uint16_t bytes : {JAVINO_MEMORY, JAVINO_MEMORY + 100, JAVINO_MEMORY + 400}) {
    Conversation c(bytes);
    c.hear(frame1("getPercepts"));
    std::string all;
    for (int i = 0; i < 60; i++) {
      std::string percept = "dist(s" + std::to_string(i) + "," + std::to_string(i * 37) + ")";
      CHECK(c.percept(percept));
      all += percept + ";";
    }
    javino_board_answer(&c.board);
    std::string together;
    for (const std::string &payload : payloads1(c.sent())) {
      CHECK(payload.size() <= 255);
      CHECK(payload.back() == ';');
      together += payload;
    }
    CHECK(together == all);
  }
}

TEST_CASE("percepts too many for one frame: version 2 sends fragments of one message") {
  for (int percepts : {0, 1, 30, 31, 32, 60, 300}) {
    Conversation c;
    c.hear(frame2("getPercepts", 0, 0));
    std::string all;
    for (int i = 0; i < percepts; i++) {
      c.percept("abcdefg");
      all += "abcdefg;";
    }
    javino_board_answer(&c.board);
    CHECK(message2(c.sent(), 0) == all);
  }
}

TEST_CASE("an answer of exactly one frame is one frame") {
  Conversation c;
  c.hear(frame2("getPercepts", 0, 0));
  c.percept(std::string(254, 'a'));
  javino_board_answer(&c.board);
  CHECK(c.sent() == frame2(std::string(254, 'a') + ";", 0, 0));
}

TEST_CASE("a percept longer than a frame: version 1 leaves it out and keeps the others, version 2 sends it") {
  std::string huge = "say(\"" + std::string(400, 'x') + "\")";
  Conversation c;
  c.hear(frame1("getPercepts"));
  CHECK(c.percept("a"));
  CHECK(!c.percept(huge));
  CHECK(c.percept("b"));
  javino_board_answer(&c.board);
  std::string together;
  for (const std::string &payload : payloads1(c.sent()))
    together += payload;
  CHECK(together == "a;b;");
  c.hear(frame2("getPercepts", 0, 0));
  CHECK(c.percept(huge));
  javino_board_answer(&c.board);
  CHECK(message2(c.sent(), 2) == huge + ";");
}

TEST_CASE("without a request percepts wait, as many as there is memory for, and go with the next answer") {
  Conversation c;
  int kept = 0;
  while (c.percept("event(" + std::to_string(kept + 10) + ")") && kept < 1000)
    kept++;
  CHECK(kept == 255 / 10);
  CHECK(c.sent() == "");
  c.hear(frame1("getPercepts"));
  javino_board_answer(&c.board);
  CHECK(payloads1(c.sent()).back().find("event(" + std::to_string(kept + 9) + ");") != std::string::npos);
}

TEST_CASE("percepts that wait do not keep requests and actions from arriving") {
  for (uint16_t bytes : {JAVINO_MEMORY_MIN, 255, 256, 300, 600}) {
    Conversation c(bytes);
    while (c.percept("event")) {
    }
    CHECK(c.hear(frame2("say(\"" + std::string(50, 'x') + "\")", 2, 1)) == JAVINO_ACTION);
    CHECK(c.hear(frame1("getPercepts")) == JAVINO_REQUEST);
    // There is more room now, and what has waited goes with it.
    CHECK(c.percept("dist(f,1)"));
    javino_board_answer(&c.board);
    std::string answer;
    for (const std::string &payload : payloads1(c.sent().substr(12)))
      answer += payload;
    CHECK(answer.substr(answer.size() - 22) == "event;event;dist(f,1);");
  }
}

TEST_CASE("percepts that have waited and those of the answer are one message where the memory holds it") {
  Conversation c;
  for (int i = 0; i < 10; i++)
    c.percept("event");
  c.hear(frame1("getPercepts"));
  for (int i = 0; i < 10; i++)
    c.percept("dist(f,1)");
  javino_board_answer(&c.board);
  CHECK(payloads1(c.sent()).size() == 1);
}

TEST_CASE("percepts that nobody has asked for have all memory but what the longest frame needs") {
  for (uint16_t bytes : {JAVINO_MEMORY_MIN, JAVINO_MEMORY, 368, 640, 4000})
    for (unsigned version : {1, 2}) {
      INFO(bytes, " bytes, version ", version);
      Conversation c(bytes);
      c.hear(version == 1 ? frame1("hello") : frame2("hello", 2, 1));
      c.poll();
      c.now += 200;
      c.poll();
      c.sent();
      std::string all;
      while (c.percept("event(" + std::to_string(all.size()) + ")"))
        all += "event(" + std::to_string(all.size()) + ");";
      size_t room = static_cast<size_t>(std::max(JAVINO_TEXT_MIN, bytes - JAVINO_WINDOW));
      room = std::min<size_t>(room, version == 1 ? 255 : JAVINO_TEXT_MAX);
      CHECK(all.size() <= room);
      CHECK(all.size() > room - 13);
      if (bytes >= JAVINO_MEMORY) {
        CHECK(c.hear(frame2(std::string(255, 'x'), 2, 3)) == JAVINO_ACTION);
        c.poll();
        c.sent();
      }
      if (version == 1) {
        c.hear(frame1("getPercepts"));
        javino_board_answer(&c.board);
        CHECK(payloads1(c.sent()) == std::vector<std::string>{all});
      } else if (bytes == 640) {
        // Sent unasked, as by a board that is only listened to.
        javino_board_answer(&c.board);
        CHECK(message2(c.sent(), 0) == all);
      } else {
        c.hear(frame2("getPercepts", 0, 1));
        CHECK(c.percept("more"));
        javino_board_answer(&c.board);
        CHECK(message2(c.sent(), 0) == all + "more;");
      }
      CHECK(c.percept("event"));
    }
}

#if JAVINO_TEXT_MAX > 255
TEST_CASE("what has waited for version 2 in more room than version 1 has is forgotten when that is spoken") {
  Conversation c(4000);
  c.hear(frame2("hello", 2, 1));
  c.poll();
  c.sent();
  for (int i = 0; i < 100; i++)
    CHECK(c.percept("event"));
  c.hear(frame1("getPercepts"));
  std::string all;
  for (int i = 0; i < 100; i++) {
    CHECK(c.percept("dist(f,1)"));
    all += "dist(f,1);";
  }
  javino_board_answer(&c.board);
  std::string together;
  for (const std::string &payload : payloads1(c.sent())) {
    CHECK(payload.back() == ';');
    together += payload;
  }
  CHECK(together == all);
}
#endif

TEST_CASE("a message that was begun and not sent makes no board deaf") {
  for (uint16_t bytes : {JAVINO_MEMORY_MIN, 272, 278, 300, JAVINO_MEMORY, 600, 4000})
    for (unsigned version : {1, 2})
      for (int percepts : {1, 5, 30, 100}) {
        Conversation c(bytes);
        auto request = [&](unsigned n) { return version == 1 ? frame1("getPercepts") : frame2("getPercepts", 0, n); };
        INFO(bytes, " bytes, version ", version, ", ", percepts, " percepts");
        CHECK(c.hear(request(0)) == JAVINO_REQUEST);
        for (int i = 0; i < percepts; i++)
          c.percept("dist(front,120)");
        javino_percept_text(&c.board, "unfini");
        CHECK(c.poll() == JAVINO_NOTHING);
        c.sent();
        for (unsigned n = 1; n < 4; n++) {
          javino_event event = c.hear(frame2("say(" + std::string(80, 'x') + ")", 2, n));
          REQUIRE(event == (bytes == JAVINO_MEMORY_MIN ? JAVINO_NOTHING : JAVINO_ACTION));
          REQUIRE(c.hear(request(n)) == JAVINO_REQUEST);
          CHECK(c.percept("ready"));
          c.sent();
          javino_board_answer(&c.board);
          std::string answer = c.sent();
          CHECK(answer.find("ready;") != std::string::npos);
          CHECK(answer.find("unfini") == std::string::npos);
          c.now += 200;
          c.poll();
          c.sent();
        }
      }
}

TEST_CASE("a message of which a part has gone out is ended before the next") {
  Conversation c(300);
  c.hear(frame2("getPercepts", 0, 0));
  std::string all;
  for (int i = 0; i < 40; i++) {
    c.percept("dist(front,120)");
    all += "dist(front,120);";
  }
  c.hear(frame2("getPercepts", 0, 1));
  CHECK(message2(c.sent(), 0) == all);
}

TEST_CASE("bytes that arrive while an answer is written are kept") {
  Conversation c;
  c.receive(frame1("getPercepts") + frame1("ledOn"));
  CHECK(c.poll() == JAVINO_REQUEST);
  c.percept("a");
  c.receive(frame1("ledOff"));
  CHECK(c.waiting.empty());
  javino_board_answer(&c.board);
  c.receive(frame1("stop"));
  for (std::string expected : {"ledOn", "ledOff", "stop"}) {
    CHECK(c.poll() == JAVINO_ACTION);
    CHECK(c.text() == expected);
  }
}

TEST_CASE("a frame of 255 bytes arrives whole in the least memory that promises it") {
  for (unsigned version : {1, 2}) {
    Conversation c(JAVINO_MEMORY);
    std::string payload(255, 'x');
    CHECK(c.hear(version == 1 ? frame1(payload) : frame2(payload, 2, 3)) == JAVINO_ACTION);
    CHECK(c.text() == payload);
    // What follows has to wait for the bytes of this one.
    std::string next = frame1("ledOn");
    c.receive(next.substr(0, 6));
    CHECK(c.poll() == JAVINO_NOTHING);
    CHECK(c.hear(next.substr(6)) == JAVINO_ACTION);
  }
}

TEST_CASE("a long version 1 message goes out as messages of whole percepts") {
  std::string text, expected;
  for (int i = 0; i < 40; i++)
    text += "say(\"a;b\",[c;d]," + std::to_string(i) + ");";
  Conversation c;
  CHECK(javino_board_send(&c.board, text.data(), text.size()));
  std::string together;
  for (const std::string &payload : payloads1(c.sent())) {
    CHECK(payload.size() <= 255);
    CHECK(payload.substr(payload.size() - 2) == ");");
    together += payload;
  }
  CHECK(together == text);
}

TEST_CASE("a long version 1 message leaves out only what fits no frame") {
  Conversation c;
  std::string huge(300, 'x');
  std::string text = "a;" + huge + ";b;" + huge + ";c";
  CHECK(!javino_board_send(&c.board, text.data(), text.size()));
  std::string together;
  for (const std::string &payload : payloads1(c.sent()))
    together += payload;
  CHECK(together == "a;b;c");
  CHECK(!javino_board_send(&c.board, huge.data(), huge.size()));
  CHECK(c.sent() == "");
}

TEST_CASE("random long messages are never cut inside a percept and lose none that fits") {
  std::mt19937 random(4);
  for (int round = 0; round < 2000; round++) {
    std::string text, fitting;
    for (size_t n = random() % 12; n > 0; n--) {
      std::string percept(random() % (random() % 5 ? 90 : 300), 'x');
      percept += ";";
      text += percept;
      if (percept.size() <= 255)
        fitting += percept;
    }
    Conversation c;
    bool complete = javino_board_send(&c.board, text.data(), text.size());
    std::string together;
    for (const std::string &payload : payloads1(c.sent()))
      together += payload;
    REQUIRE(together == fitting);
    REQUIRE(complete == (text == fitting));
  }
}

TEST_CASE("a lost link is reported once, and again only after something valid has arrived") {
  Conversation c;
  uint32_t now = 4294967000u;  // The clock wraps around on the way.
  auto lost = [&](uint32_t later) {
    now += later;
    c.now = static_cast<uint16_t>(now);
    c.poll();
    return javino_link_lost(&c.board.link, 1000, now);
  };
  javino_link_supervise(&c.board.link, now);
  CHECK(!lost(0));
  CHECK(!lost(1000));
  CHECK(lost(1));
  CHECK(!lost(5000));
  c.receive("noise that is no frame");
  CHECK(!lost(500));
  c.receive(frame2("getPercepts", 0, 1).substr(0, 20));
  CHECK(!lost(5000));
  c.receive(frame2("getPercepts", 0, 1));
  CHECK(!lost(1));
  CHECK(!lost(999));
  CHECK(lost(3));
}

TEST_CASE("what has waited while the program was busy is not fresh") {
  Conversation c;
  uint32_t now = c.now;
  auto turn = [&](uint32_t later, const std::string &bytes) {
    now += later;
    c.now = static_cast<uint16_t>(now);
    c.find(bytes);
    bool lost = false;
    do
      c.poll(), lost |= javino_link_lost(&c.board.link, 1000, now);
    while (c.board.link.event != JAVINO_NOTHING);
    return lost;
  };
  javino_link_supervise(&c.board.link, now);
  CHECK(!turn(10, frame1("hello")));
  // Where several have waited none is newer than the others.
  CHECK(turn(2000, frame1("hello") + frame1("hello") + frame1("hello")));
  CHECK(!turn(10, frame1("hello")));
  CHECK(!turn(900, ""));
  CHECK(!turn(90, frame1("hello")));
  CHECK(!turn(909, ""));
  CHECK(turn(1000, ""));
}

TEST_CASE("a board with too little memory says so") {
  std::vector<uint8_t> memory(JAVINO_MEMORY_MIN);
  javino_board board;
  for (uint16_t bytes : {0, 63, 64, JAVINO_MEMORY_MIN - 1})
    CHECK(!javino_board_init(&board, memory.data(), bytes, Conversation::write, nullptr));
  CHECK(javino_board_init(&board, memory.data(), JAVINO_MEMORY_MIN, Conversation::write, nullptr));
}

TEST_CASE("memory is taken from the end as long as enough is left") {
  Conversation c(JAVINO_MEMORY_MIN + 20);
  uint8_t *end = c.memory.data() + c.memory.size();
  CHECK(javino_board_take(&c.board, 6) == end - 6);
  CHECK(javino_board_take(&c.board, 6) == end - 12);
  for (uint16_t too_much : {60000, 65440, 65535})
    CHECK(javino_board_take(&c.board, too_much) == nullptr);
  CHECK(javino_board_take(&c.board, 9) == nullptr);
  CHECK(javino_board_take(&c.board, 8) == end - 20);
  CHECK(javino_board_take(&c.board, 1) == nullptr);
  c.percept("a");
  CHECK(javino_board_take(&c.board, 0) == nullptr);
}

TEST_CASE("terms are written as atoms, strings and numbers") {
  Conversation c;
  c.hear(frame1("getPercepts"));
  REQUIRE(javino_percept_begin(&c.board, "p"));
  javino_percept_put(&c.board, '(');
  for (const char *text : {"front", "fRont_2", "Front", "2nd", "hi, you", "say \"hi\\\"", ""}) {
    javino_percept_term(&c.board, text);
    javino_percept_put(&c.board, ',');
  }
  javino_percept_number(&c.board, 0, false);
  javino_percept_put(&c.board, ',');
  javino_percept_number(&c.board, 4294967295u, true);
  javino_percept_put(&c.board, ')');
  javino_percept_end(&c.board);
  javino_board_answer(&c.board);
  CHECK(c.sent() == frame1(R"x(p(front,fRont_2,"Front","2nd","hi, you","say \"hi\\\"","",0,-4294967295);)x"));
}

TEST_CASE("random bytes through the whole conversation do no harm") {
  std::mt19937 random(5);
  Conversation c(JAVINO_MEMORY_MIN);
  const std::string pieces[] = {"fffe", "fffd", "getPercepts", "0B", "(", ")", "ledOn", "05", "F", ";", "\"", frame1("getPercepts"), frame2("x", 3, 1)};
  long events = 0;
  for (int i = 0; i < 300000; i++) {
    std::string piece = random() % 4 ? pieces[random() % 13] : std::string(1, static_cast<char>(random()));
    for (unsigned char byte : piece)
      if (javino_link_ready(&c.board.link))
        javino_link_receive(&c.board.link, byte, c.now);
    if (random() % 50 == 0)
      c.now = static_cast<uint16_t>(c.now + random() % 300);
    if (random() % 3 == 0) {
      if (c.poll() == JAVINO_REQUEST) {
        for (size_t n = random() % 20; n > 0; n--)
          c.percept("dist(front,100)");
        javino_board_answer(&c.board);
      }
      events++;
      c.sent();
    }
  }
  CHECK(events > 0);
}

TEST_CASE("a literal is taken apart outside quotes and brackets") {
  auto functor = [](const std::string &text) { return javino_functor(text.data(), static_cast<uint8_t>(text.size())); };
  CHECK(functor("ledOn") == 5);
  CHECK(functor("speed(120)") == 5);
  CHECK(functor("say(\"hi; you)\")") == 3);
  CHECK(functor("move(left,pos(1,[2,3]))[now]") == 4);
  CHECK(functor("go()[a]") == 2);
  CHECK(functor("go[a]") == 2);
  CHECK(functor("f(\",\",',')") == 1);
  CHECK(functor("drive('C:\\')") == 5);
  CHECK(functor("f((((((((((((((((((((1))))))))))))))))))))") == 1);
  for (const char *bad : {"", "speed(120", "speed 120)", "speed(1)(2)", "speed(1)x", "speed)", "say(\"hi)", "(1)", "go[a](1)", "a\"b\"", "speed(1]]", "speed(1]", "speed(1}", "f([1)]", "f(,1)", "f(1,)", "f(1,,2)", "f( , 1)", "f([,1])"}) {
    INFO(bad);
    CHECK(functor(bad) == 0);
  }
  std::string text = "move( left , \"a,b(\" ,pos(1,2),-7)[x(9)]";
  const char *argument;
  std::vector<std::string> found;
  for (uint8_t i = 0;; i++) {
    uint8_t n = javino_argument(text.data(), static_cast<uint8_t>(text.size()), i, &argument);
    if (!n)
      break;
    found.push_back(std::string(argument, n));
  }
  CHECK(found == std::vector<std::string>{"left", "\"a,b(\"", "pos(1,2)", "-7"});
}

TEST_CASE("whole numbers are read, others are not") {
  auto number = [](const std::string &text) {
    int32_t value = 4711;
    bool read = javino_number(text.data(), static_cast<uint8_t>(text.size()), &value);
    return read ? std::to_string(value) : "none";
  };
  CHECK(number("120") == "120");
  CHECK(number("-7") == "-7");
  CHECK(number("+7") == "7");
  CHECK(number("2147483647") == "2147483647");
  CHECK(number("-2147483648") == "-2147483648");
  for (const char *bad : {"", "-", "+", "1.5", "x", "12x", "2147483648", "-2147483649", "99999999999999", " 1"})
    CHECK(number(bad) == "none");
}
