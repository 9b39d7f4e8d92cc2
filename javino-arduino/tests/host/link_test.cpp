// The conversation: sessions, commands and their outcomes, versions side by side, a lost link.

#include <random>

#include "conversation.h"
#include "javino_rules.h"

TEST_CASE("a request of version 1 is answered in version 1, in a session too") {
  Conversation c;
  CHECK(c.hear(frame1("getPercepts")) == JAVINO_REQUEST);
  c.percept("dist(f,10)");
  javino_board_answer(&c.board);
  CHECK(c.sent() == frame1("dist(f,10);"));
  c.begin();
  CHECK(c.hear(ask(1)) == JAVINO_REQUEST);
  c.percept("dist(f,11)");
  c.percept("light(b,40)");
  CHECK(c.answered(1) == "dist(f,11);light(b,40);");
  c.poll();
  c.now += 26;
  CHECK(c.hear(frame1("getPercepts")) == JAVINO_REQUEST);
  javino_board_answer(&c.board);
  CHECK(c.sent() == frame1(""));
}

TEST_CASE("only getPercepts and getPercepts(...) are requests of version 1") {
  Conversation c;
  CHECK(c.hear(frame1("getPerceptsNow")) == JAVINO_ACTION);
  CHECK(c.hear(frame1("getPercept")) == JAVINO_ACTION);
  CHECK(c.hear(frame1("getPercepts(dist)")) == JAVINO_REQUEST);
  CHECK(c.text() == "(dist)");
}

TEST_CASE("a command and a request in one burst are both handled, in order") {
  Conversation c;
  c.receive(frame1("ledOn") + frame1("getPercepts") + hello() + command(0, "stop") + ask(1));
  CHECK(c.poll() == JAVINO_ACTION);
  CHECK(c.text() == "ledOn");
  CHECK(c.poll() == JAVINO_REQUEST);
  CHECK(c.poll() == JAVINO_ACTION);
  CHECK(c.text() == "stop");
  CHECK(c.poll() == JAVINO_REQUEST);
  CHECK(c.poll() == JAVINO_NOTHING);
}

TEST_CASE("version 1 is never acknowledged") {
  Conversation c;
  CHECK(c.hear(frame1("ledOn")) == JAVINO_ACTION);
  c.finish();
  CHECK(c.hear(frame1("nonsense")) == JAVINO_ACTION);
  c.finish(false);
  c.poll();
  CHECK(c.sent() == "");
}

TEST_CASE("frames of another session are damaged") {
  Conversation c;
  c.begin(9);
  for (unsigned nonce = 0; nonce < 256; nonce++)
    if (nonce != 9) {
      CHECK(c.hear(frame2(0x30, 0, item("front"), nonce)) == JAVINO_NOTHING);
      CHECK(c.hear(frame2(0x20, 1, "", nonce)) == JAVINO_NOTHING);
    }
  CHECK(c.sent() == "");
  CHECK(c.board.link.decoder.damaged == 2 * 255 % 256);
  CHECK(c.hear(command(0, "front")) == JAVINO_ACTION);
}

TEST_CASE("WELCOME says what the board takes, and which actions found no room") {
  Conversation c;
  c.hear(hello(9));
  auto frames = frames2(c.sent());
  REQUIRE(frames.size() == 1);
  CHECK(frames[0].kind == 0x80);
  CHECK(frames[0].number == 0);
  CHECK(frames[0].payload == std::string{9, JAVINO_CREDIT, octet(255), 0, JAVINO_REVISION, 0});
  c.board.link.actions_lost = 51;
  c.hear(hello());
  CHECK(frames2(c.sent())[0].payload.back() == 51);
  Conversation small(JAVINO_MEMORY_MIN);
  small.hear(hello(9));
  unsigned longest = static_cast<uint8_t>(frames2(small.sent())[0].payload[2]);
  CHECK(longest == 89);
  CHECK(small.hear(frame2(0x30, 0, item(std::string(longest - 1, '\xA5')))) == JAVINO_ACTION);
}

TEST_CASE("commands are handed out one by one and acknowledged together") {
  Conversation c;
  c.actions = {{"front", 0}, {"left", 0}};
  c.begin();
  CHECK(c.hear(frame2(0x30, 0, "\x80" + item("speed(120)") + "\xFE\x81" + item(std::string(200, 'x')))) == JAVINO_ACTION);
  for (const std::string &expected : {std::string("front"), std::string("speed(120)"), std::string("left"), std::string(200, 'x')}) {
    CHECK(c.text() == expected);
    CHECK(c.sent() == "");
    c.poll();
  }
  CHECK(c.sent() == ack(5));
}

TEST_CASE("a repeated command is acknowledged and not handed out again") {
  Conversation c;
  c.begin();
  CHECK(c.hear(command(0, "toggle")) == JAVINO_ACTION);
  c.poll();
  CHECK(c.sent() == ack(1));
  for (unsigned busy : {0, 500, 3200, 20000, 40000}) {
    c.now = static_cast<uint16_t>(c.now + busy);
    for (int repeat = 0; repeat < 3; repeat++)
      c.find(command(0, "toggle"));
    CHECK(c.poll() == JAVINO_NOTHING);
    CHECK(c.sent() == ack(1) + ack(1) + ack(1));
  }
  CHECK(c.hear(command(1, "toggle")) == JAVINO_ACTION);
}

TEST_CASE("a number that is none of the vocabulary's is refused, and so is any where there is none") {
  Conversation c;
  c.actions = {{"front", 0}};
  c.begin();
  CHECK(c.hear(frame2(0x30, 0, "\x81")) == JAVINO_NOTHING);
  CHECK(c.sent() == ack(1, REFUSED));
  c.actions = {};
  CHECK(c.hear(frame2(0x31, 1, "\x80")) == JAVINO_NOTHING);
  CHECK(c.sent() == ack(2, REFUSED));
}

TEST_CASE("a flood of frames does not keep the program") {
  Conversation c;
  c.begin();
  c.receive(hello(1) + hello(2) + hello(3) + hello(4) + hello(5) + hello(6) + hello(8) + hello(9) + hello(10) + hello(11));
  c.poll();
  CHECK(frames2(c.sent()).size() == 8);
  c.poll();
  CHECK(frames2(c.sent()).size() == 2);
}

TEST_CASE("bytes that waited while the program was busy are not late") {
  for (uint16_t busy : {101, 150, 300, 1000}) {
    for (const std::string &frame : {frame1("ledOn"), command(0, "ledOn\xA4"), ask(1)}) {
      for (size_t cut = 1; cut < frame.size(); cut++) {
        Conversation c;
        if (frame[0] == '\xA5')
          c.begin();
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
  c.begin();
  c.find(ask(1, 0, "(" + std::string(50, 'x') + ")") + command(0, "ledOn") + ask(2, 0, "(" + std::string(50, 'x') + ")"));
  int found = 0;
  for (int turn = 0; turn < 12; turn++) {
    found += c.poll() != JAVINO_NOTHING;
    c.now += 300;
  }
  CHECK(found == 3);
}

TEST_CASE("an outcome that is reported later keeps the board BUSY, which goes on answering") {
  for (bool done : {true, false}) {
    Conversation c;
    c.begin();
    CHECK(c.hear(frame2(0x30, 0, item("close") + item("open"))) == JAVINO_ACTION);
    javino_later later = javino_link_later(&c.board.link);
    REQUIRE(later != 0);
    c.finish();
    c.poll();
    CHECK(c.sent() == ack(0, BUSY));
    for (int i = 0; i < 20; i++) {
      c.now += 250;
      CHECK(c.hear(frame2(0x30, 0, item("close") + item("open"))) == JAVINO_NOTHING);
      CHECK(c.sent() == ack(0, BUSY));
      CHECK(c.hear(ask(1)) == JAVINO_REQUEST);
      c.poll();
    }
    CHECK(javino_link_done(&c.board.link, later, done));
    CHECK(c.sent() == ack(1, done ? 0 : REFUSED));
    CHECK(!javino_link_done(&c.board.link, later, done));
    CHECK(c.hear(command(0, "close")) == JAVINO_NOTHING);
    CHECK(c.sent() == ack(1, done ? 0 : REFUSED));
    CHECK(c.hear(frame2(0x31, 1, item("open"))) == JAVINO_ACTION);
  }
}

TEST_CASE("an outcome that nobody waits for any more is not reported") {
  Conversation c;
  CHECK(javino_link_later(&c.board.link) == 0);
  c.hear(frame1("close"));
  CHECK(javino_link_later(&c.board.link) == 0);
  CHECK(!javino_link_done(&c.board.link, 0, true));
  c.begin();
  c.hear(command(0, "close"));
  javino_later first = javino_link_later(&c.board.link);
  c.begin(8);
  CHECK(!javino_link_done(&c.board.link, first, true));
  c.hear(command(0, "open"));
  javino_later second = javino_link_later(&c.board.link);
  c.poll();
  CHECK(c.sent() == ack(0, BUSY));
  CHECK(!javino_link_done(&c.board.link, first, true));
  CHECK(c.sent() == "");
  CHECK(javino_link_done(&c.board.link, second, true));
  CHECK(c.sent() == ack(1));
}

TEST_CASE("a command whose outcome is reported at once, within later() and done(), is one like any other") {
  Conversation c;
  c.begin();
  c.hear(frame2(0x30, 0, item("close") + item("open")));
  CHECK(javino_link_done(&c.board.link, javino_link_later(&c.board.link), true));
  CHECK(c.sent() == ack(1));
  CHECK(c.poll() == JAVINO_ACTION);
  CHECK(c.text() == "open");
  c.poll();
  CHECK(c.sent() == ack(2));
}

TEST_CASE("what a board sends is no message to one") {
  Conversation c;
  c.begin();
  for (unsigned kind : {0x80, 0x81, 0x82, 0xC1, 0x11, 0x32, 0x00})
    CHECK(c.hear(frame2(kind, 1, "a")) == JAVINO_NOTHING);
  CHECK(c.sent() == "");
}

TEST_CASE("no frame of version 1 inside the text of a damaged command is carried out in a session") {
  std::string nasty = command(0, "say(\"" + frame1("ledOn") + "\")");
  for (size_t at = 0; at < nasty.size(); at++) {
    Conversation c;
    c.begin();
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

TEST_CASE("a command longer than the memory is dropped, and nothing in it is carried out") {
  for (const std::string &inside : {frame1("front"), command(0, "front")}) {
    Conversation c(232);
    c.begin();
    CHECK(c.hear(command(0, "say(\"" + std::string(210, 'x') + inside + "\")")) == JAVINO_NOTHING);
    c.now += 101;
    CHECK(c.poll() == JAVINO_NOTHING);
    CHECK(c.hear(command(0, "front")) == JAVINO_ACTION);
  }
}

TEST_CASE("in a session a frame of version 1 counts behind a silence of a quarter of the timeout") {
  Conversation c;
  c.begin();
  CHECK(c.hear(frame1("ledOn")) == JAVINO_NOTHING);
  c.now += 101;
  CHECK(c.hear("noise") == JAVINO_NOTHING);
  CHECK(c.hear(frame1("ledOff")) == JAVINO_NOTHING);
  c.now += 26;
  CHECK(c.hear(frame1("ledOff")) == JAVINO_ACTION);
  CHECK(c.text() == "ledOff");
}

TEST_CASE("a program that speaks version 1 ends the session of an earlier one") {
  for (const std::string &first : {frame1("ledOn"), frame1("getPercepts")}) {
    Conversation c;
    c.begin();
    c.now += 26;
    CHECK(c.hear(first + frame1("ledOff")) != JAVINO_NOTHING);
    CHECK(c.poll() == JAVINO_ACTION);
    CHECK(c.text() == "ledOff");
    CHECK(c.hear("noise" + frame1("ledOn")) == JAVINO_ACTION);
    c.sent();
    CHECK(c.hear(ask(1)) == JAVINO_NOTHING);
    CHECK(frames2(c.sent()).at(0).payload.at(0) == 0);
  }
}

TEST_CASE("an answer that goes out in parts ends with the session") {
  for (uint16_t bytes : {JAVINO_MEMORY + 255, 8192}) {
    Conversation c(bytes);
    REQUIRE(javino_rules_init(&c.board, 250, [](void *, const char *, uint8_t) { return true; }, nullptr));
    c.begin();
    CHECK(c.hear(frame2(0x30, 0, ruleItem(std::string("\x01" "a\x00", 3)))) == JAVINO_NOTHING);
    CHECK(c.hear(ask(1)) == JAVINO_REQUEST);
    c.percept("dist(front,123)");
    c.percept("light(front,95)");
    javino_board_answer(&c.board);
    c.now += 26;
    CHECK(c.hear(frame1("getPercepts")) == JAVINO_REQUEST);
    CHECK(frames2(c.sent()).back().kind == 0x83); // a part that was to go before the request was found
    c.percept("one");
    javino_board_answer(&c.board);
    CHECK(payloads1(c.sent()) == std::vector<std::string>{"one;"});
    c.poll();
    CHECK(c.sent().empty());
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
  c.receive("noise that is no frame\xA5\x01\x30\x02");
  CHECK(!lost(500));
  c.receive(ask(1).substr(0, 6));
  CHECK(!lost(5000));
  c.receive(ask(1));
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
  // If several have waited, none is newer than the others.
  CHECK(turn(2000, frame1("hello") + frame1("hello") + frame1("hello")));
  CHECK(!turn(10, frame1("hello")));
  CHECK(!turn(900, ""));
  CHECK(!turn(90, frame1("hello")));
  CHECK(!turn(909, ""));
  CHECK(turn(1000, ""));
}

TEST_CASE("random bytes through the whole conversation do no harm") {
  std::mt19937 random(5);
  const std::string pieces[] = {"fffe", "getPercepts", "0B", "(", ")", "ledOn", "05", ";", "\"", "\xA5", "\xA4",
                                frame1("getPercepts"), hello(), ask(3, 2), command(0, "x"), describe(1, 1)};
  for (uint16_t bytes : {JAVINO_MEMORY_MIN, JAVINO_MEMORY + 255}) {
    Conversation c(bytes);
    c.actions = {{"front", 0}, {"speed", 1}};
    long events = 0;
    for (int i = 0; i < 300000; i++) {
      std::string piece = random() % 4 ? pieces[random() % 16] : std::string(1, static_cast<char>(random()));
      for (unsigned char byte : piece)
        if (javino_link_ready(&c.board.link))
          javino_link_receive(&c.board.link, byte, c.now);
      if (random() % 50 == 0)
        c.now = static_cast<uint16_t>(c.now + random() % 300);
      if (random() % 3 == 0) {
        if (c.poll() == JAVINO_REQUEST) {
          for (size_t n = random() % 20; n > 0; n--)
            c.percept("dist(front," + std::to_string(random() % 1000) + ")");
          javino_board_answer(&c.board);
        } else if (random() % 5 == 0) {
          c.percept("event(" + std::to_string(random() % 30) + std::string(random() % 99, 'x') + ")");
        } else if (random() % 50 == 0) {
          javino_board_answer(&c.board);
        }
        events++;
        c.sent();
      }
    }
    CHECK(events > 0);
  }
}

namespace {

/** A computer and a board on a line that damages one byte in a hundred, loses some and is silent now and then. */
struct Exchange {
  std::mt19937 random;
  Conversation board;
  std::vector<std::string> carried;
  unsigned due = 0; /* as the computer knows it */

  explicit Exchange(unsigned seed) : random(seed) { board.begin(); }

  std::string damaged(std::string bytes) {
    for (size_t i = 0; i < bytes.size(); i++)
      if (random() % 100 == 0)
        switch (random() % 3) {
        case 0: bytes[i] = static_cast<char>(random()); break;
        case 1: bytes.erase(i, 1); break;
        default: bytes.insert(i, 1, static_cast<char>(random()));
        }
    return bytes;
  }

  void turn(const std::string &frame) {
    board.now = static_cast<uint16_t>(board.now + random() % 60);
    board.receive(damaged(frame));
    for (int i = 0; i < 9; i++)
      if (board.poll() == JAVINO_ACTION)
        carried.push_back(board.text());
    std::string out = board.sent();
    if (random() % 10 == 0)
      return;
    for (const Frame2 &frame : frames2(out))
      if (frame.kind == 0x81)
        due = frame.number;
  }
};

}  // namespace

TEST_CASE("on a damaged line every command is carried out once, in order, and none else") {
  for (unsigned seed = 1; seed < 4; seed++) {
    Exchange e(seed);
    const unsigned total = 5000;
    unsigned done = 0, repeats = 0;
    while (done < total && repeats < 100 * total) {
      std::string row;
      unsigned out = std::min(8u, total - done);
      for (unsigned i = 0; i < out; i++)
        row += item("go(" + std::to_string(done + i) + ")");
      e.turn(frame2(0x30, done & 255, row));
      unsigned news = (e.due - done) & 255;
      if (news <= out)
        done += news;
      repeats++;
    }
    REQUIRE(e.carried.size() == total);
    for (unsigned i = 0; i < total; i++)
      REQUIRE(e.carried[i] == "go(" + std::to_string(i) + ")");
  }
}
