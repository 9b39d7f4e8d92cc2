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
  uint16_t now = 1000;

  explicit Conversation(uint16_t bytes = JAVINO_MEMORY + 255) : memory(bytes) {
    javino_board_init(&board, memory.data(), bytes, write, this);
  }

  static void write(void *self, uint8_t byte) { static_cast<Conversation *>(self)->out += static_cast<char>(byte); }

  void receive(const std::string &bytes) {
    for (unsigned char byte : bytes) {
      REQUIRE(javino_link_ready(&board.link, now));
      javino_link_receive(&board.link, byte, now);
    }
  }

  javino_event poll() { return javino_link_poll(&board.link, now); }

  javino_event hear(const std::string &bytes) {
    receive(bytes);
    return poll();
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
  javino_link_finish(&c.board.link, true, c.now);
  CHECK(c.hear(frame1("nonsense")) == JAVINO_ACTION);
  javino_link_finish(&c.board.link, false, c.now);
  c.poll();
  CHECK(c.sent() == "");
}

TEST_CASE("a version 2 action is acknowledged when it has been carried out, with its own sequence number") {
  Conversation c;
  CHECK(c.hear(frame2("ledOn", 2, 9)) == JAVINO_ACTION);
  CHECK(c.sent() == "");
  javino_link_finish(&c.board.link, true, c.now);
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
  javino_link_finish(&c.board.link, false, c.now);
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
    javino_link_finish(&c.board.link, done, c.now);
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
  while (c.percept("event(" + std::to_string(kept) + ")") && kept < 1000)
    kept++;
  CHECK(kept == JAVINO_TEXT_MIN / 9);
  CHECK(c.sent() == "");
  c.hear(frame1("getPercepts"));
  javino_board_answer(&c.board);
  CHECK(payloads1(c.sent()).at(0).find("event(" + std::to_string(kept - 1) + ");") != std::string::npos);
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
  while (c.percept("event")) {
  }
  c.hear(frame1("getPercepts"));
  for (int i = 0; i < 10; i++)
    c.percept("dist(f,1)");
  javino_board_answer(&c.board);
  CHECK(payloads1(c.sent()).size() == 1);
}

TEST_CASE("bytes that arrive while an answer is written are kept") {
  Conversation c;
  c.receive(frame1("getPercepts") + frame1("ledOn"));
  CHECK(c.poll() == JAVINO_REQUEST);
  c.percept("a");
  c.receive(frame1("ledOff"));
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

TEST_CASE("memory is taken from the end as long as enough is left") {
  Conversation c(JAVINO_MEMORY_MIN + 20);
  uint8_t *end = c.memory.data() + c.memory.size();
  CHECK(javino_board_take(&c.board, 6) == end - 6);
  CHECK(javino_board_take(&c.board, 6) == end - 12);
  CHECK(javino_board_take(&c.board, 60000) == nullptr);
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
      if (javino_link_ready(&c.board.link, c.now))
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
