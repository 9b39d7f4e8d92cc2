// The Arduino class, as sketches use it.

#include <doctest/doctest.h>

#include <Javino.h>

#include <random>
#include <string>
#include <vector>

#include "frames.h"

namespace {

std::vector<std::string> done;

void ledOn() { done.push_back("ledOn"); }
void led() { done.push_back("led"); }
void speed(const JavinoArguments &arguments) {
  done.push_back("speed " + std::to_string(arguments.count()) + " " + std::to_string(arguments.number(0, -1)));
}
bool turn(const JavinoArguments &arguments) {
  if (arguments.count() != 2 || !arguments.is(0, "left") || !arguments.isNumber(1))
    return false;
  done.push_back("turn " + std::to_string(arguments.number(1)));
  return true;
}
std::string said;
void say(const JavinoArguments &arguments) { said = arguments.text(0).c_str(); }

/** A board on Serial, with everything as after power-on. */
struct Board {
  Javino javino;

  Board() {
    Serial.in.clear();
    Serial.meanwhile.clear();
    Serial.sent();
    stub_millis = 5000;
    done.clear();
    javino.start(9600);
    javino.run();
  }

  std::string run(const std::string &bytes) {
    Serial.receive(bytes);
    javino.run();
    return Serial.sent();
  }

  /** Begins a session and forgets the answer. */
  void begin(unsigned nonce = 7) { run(hello(nonce)); }

  /** Returns the text of the answer to a request, read with the shapes of earlier answers. */
  std::string percepts(unsigned request, const std::string &functors = "") {
    return percepts_.read(run(ask(request, percepts_.known(), functors)), request);
  }


  std::string later(unsigned long ms) {
    stub_millis += ms;
    return run("");
  }

private:
  Percepts percepts_;
};

Javino *percepts_of;
void look() {
  percepts_of->percept("dist", "front", 120);
  percepts_of->percept("light", 'b', 40u);
  percepts_of->addPercept("ready");
}

}  // namespace

TEST_CASE("start opens Serial at the rate given, above 32767 too") {
  Javino javino;
  javino.start(115200);
  CHECK(Serial.baud == 115200);
}

TEST_CASE("start opens the port given, and leaves alone a stream that is open") {
  FakeSerial other;
  Javino on_port(other);
  on_port.start(57600);
  CHECK(other.baud == 57600);
  FakeSerial open;
  Stream &stream = open;
  Javino on_stream(stream);
  on_stream.start(57600);
  CHECK(open.baud == 0);
  open.receive(frame1("getPercepts"));
  on_stream.run();
  CHECK(open.sent() == frame1(""));
}

TEST_CASE("perceive's function writes the answer") {
  Board board;
  percepts_of = &board.javino;
  board.javino.perceive(look);
  CHECK(board.run(frame1("getPercepts")) == frame1("dist(front,120);light(b,40);ready;"));
  board.begin();
  CHECK(board.percepts(1, "(light)") == "light(b,40);");
  CHECK(board.percepts(2) == "dist(front,120);light(b,40);ready;");
  CHECK(board.percepts(3) == "dist(front,120);light(b,40);ready;");
  board.javino.perceive([] {
    percepts_of->percept("~open", "door");
    percepts_of->addPercept("~open(window)");
    percepts_of->addPercept("closed(gate)");
  });
  CHECK(board.percepts(4, "(open)") == "~open(door);~open(window);");
}

TEST_CASE("a board without percepts answers all the same") {
  Board board;
  CHECK(board.run(frame1("getPercepts")) == frame1(""));
}

TEST_CASE("an answer that perceive's function has sent itself is not sent again") {
  Board board;
  percepts_of = &board.javino;
  board.javino.perceive([] {
    percepts_of->addPercept("result(1)");
    percepts_of->sendPercepts();
  });
  CHECK(board.run(frame1("getPercepts")) == frame1("result(1);"));
  board.begin();
  CHECK(board.percepts(1) == "result(1);");
}

TEST_CASE("actions are carried out by name, and only those") {
  Board board;
  board.javino.act["ledOn"] = ledOn;
  CHECK(board.run(frame1("ledOn")) == "");
  CHECK(done == std::vector<std::string>{"ledOn"});
  CHECK(board.run(frame1("ledOff")) == "");
  CHECK(board.run(frame1("ledOn(1)")) == "");
  CHECK(board.run(frame1("LEDON")) == "");
  CHECK(board.run(frame1("")) == "");
  CHECK(done.size() == 1);
  board.begin();
  CHECK(board.run(command(0, "ledOn")) == ack(1));
  CHECK(board.run(command(1, "ledOff")) == ack(2, REFUSED));
  CHECK(board.run(frame2(0x31, 2, "\x80\x80\x80")) == ack(5));
  CHECK(board.run(frame2(0x30, 5, "\x81")) == ack(6, REFUSED));
  CHECK(done.size() == 5);
}

TEST_CASE("bytes of zero in a text end neither it nor a name") {
  Board board;
  board.javino.act["led"] = led;
  board.javino.onAction("speed", speed);
  for (const std::string &text : {std::string("led\0", 4), std::string("led\0\0\0On", 8), std::string("speed\0", 6), std::string("speed\0(1)", 9)}) {
    board.later(200);
    CHECK(board.run(frame1(text)) == "");
    board.begin();
    CHECK(board.run(command(0, text)) == ack(1, REFUSED));
  }
  CHECK(done.empty());
}

TEST_CASE("a later function takes the place of an earlier one of the same name") {
  Board board;
  board.javino.act["x"] = led;
  board.javino.act["x"] = ledOn;
  board.run(frame1("x"));
  CHECK(done == std::vector<std::string>{"ledOn"});
}

TEST_CASE("an action's name may be a String, and an action may be called by its name") {
  static Board board;  // As in a sketch: its names last for ever.
  for (int i = 0; i < 3; i++)
    board.javino.act[String("led") + String(i)] = ledOn;
  board.run(frame1("led2"));
  board.javino.act["led0"]();
  board.javino.act["led9"]();
  CHECK(done.size() == 2);
}

TEST_CASE("arguments are handed over") {
  Board board;
  CHECK(board.javino.onAction("speed", speed));
  CHECK(board.javino.onAction("turn", turn));
  CHECK(board.javino.onAction("say", say));
  board.run(frame1("speed(-120)"));
  CHECK(done.back() == "speed 1 -120");
  board.run(frame1("say(\"hi; \\\"you\\\"\")"));
  CHECK(said == "hi; \"you\"");
  board.begin();
  CHECK(board.run(command(0, "turn(left, 30)")) == ack(1));
  CHECK(done.back() == "turn 30");
  unsigned due = 1;
  for (const char *bad : {"turn(right,30)", "turn(left,x)", "turn(left,3", "turnleft(1)"}) {
    CHECK(board.run(frame2(0x31, due, item(bad))) == ack(due + 1, REFUSED));
    due++;
  }
  CHECK(done.size() == 2);
  CHECK(board.run(frame2(0x31, due, item("speed[urgent]"))) == ack(due + 1));
  CHECK(done.back() == "speed 0 -1");
}

TEST_CASE("an action with another number of arguments than declared is refused, in either version") {
  Board board;
  CHECK(board.javino.onAction("speed", speed, 1));
  CHECK(board.javino.onAction("turn", turn, 2));
  for (const char *text : {"speed", "speed(1,2)", "speed()", "turn(left)", "turn(left,30,1)"})
    board.run(frame1(text) + frame1("getPercepts"));
  CHECK(done.empty());
  board.run(frame1("speed(3)") + frame1("turn(left,30)"));
  CHECK(done == std::vector<std::string>{"speed 1 3", "turn 30"});
  board.begin();
  unsigned due = 0;
  for (const char *text : {"speed", "speed(1,2)", "turn(left)"}) {
    CHECK(board.run(frame2(0x31, due, item(text))) == ack(due + 1, REFUSED));
    due++;
  }
  CHECK(board.run(frame2(0x31, due, "\x80")) == ack(due + 1, REFUSED));
  CHECK(done.size() == 2);
}

TEST_CASE("a board describes its actions in the order in which they were registered") {
  Board board;
  board.javino.act["ledOn"] = ledOn;
  board.javino.onAction("speed", speed, 1);
  board.javino.onAction("say", say);
  board.javino.onAction("stop", led);
  board.begin();
  CHECK(board.run(describe(1)) == frame2(0x86, 0, bytesOf("01 00 04") + std::string("\0\5", 2) + "ledOn" + "\x01\x05" + "speed" + "\xFF\x03" + "say" + std::string("\0\4", 2) + "stop"));
  CHECK(board.run(describe(2, 3)) == frame2(0x86, 0, bytesOf("02 03 04") + std::string("\0\4", 2) + "stop"));
  CHECK(board.run(frame2(0x30, 0, "\x83\x80")) == ack(2));
  CHECK(done == std::vector<std::string>{"led", "ledOn"});
}

TEST_CASE("an argument's text is cut to what there is room for") {
  const char literal[] = "f(\"abcdef\",\"\",x,3.25)";
  JavinoArguments arguments(literal, sizeof literal - 1);
  char text[4];
  CHECK(arguments.copy(0, text, sizeof text) == 6);
  CHECK(std::string(text) == "abc");
  CHECK(arguments.copy(1, text, sizeof text) == 0);
  CHECK(std::string(text) == "");
  CHECK(arguments.copy(7, text, sizeof text) == 0);
  CHECK(arguments.copy(0, text, 0) == 6);
  CHECK(arguments.is(1, ""));
  CHECK(!arguments.is(7, ""));
  CHECK(arguments.is(2, "x"));
  CHECK(!arguments.is(2, "xy"));
  CHECK(arguments.decimal(3) == 3.25);
  CHECK(arguments.decimal(2, -1) == -1);
  CHECK(arguments.number(3, -1) == -1);
  CHECK(arguments.count() == 4);
}

TEST_CASE("a command and a request that arrive in one burst are both handled in one run") {
  Board board;
  percepts_of = &board.javino;
  board.javino.act["ledOn"] = ledOn;
  board.javino.perceive(look);
  CHECK(board.run(frame1("ledOn") + frame1("getPercepts")) == frame1("dist(front,120);light(b,40);ready;"));
  CHECK(done.size() == 1);
}

TEST_CASE("what arrives while an answer goes out is handled next") {
  Board board;
  percepts_of = &board.javino;
  board.javino.act["ledOn"] = ledOn;
  board.javino.perceive(look);
  for (unsigned char byte : frame1("ledOn"))
    Serial.meanwhile.push_back(byte);
  board.run(frame1("getPercepts"));
  CHECK(done.size() == 1);
}

TEST_CASE("a flood does not keep the sketch from its loop") {
  Board board;
  board.javino.act["ledOn"] = ledOn;
  std::string flood;
  for (int i = 0; i < 100; i++)
    flood += frame1("ledOn");
  board.run(flood);
  CHECK(done.size() == 8);
  for (int i = 0; i < 20; i++)
    board.run("");
  CHECK(done.size() == 100);
}

TEST_CASE("version 1: a name that may be the beginning of another waits for what follows") {
  Board board;
  board.javino.act["led"] = led;
  board.javino.act["ledOn"] = ledOn;
  board.javino.onAction("speed", speed);
  SUBCASE("silence confirms it") {
    board.run(frame1("led"));
    CHECK(done.empty());
    board.later(7);
    CHECK(done == std::vector<std::string>{"led"});
  }
  SUBCASE("a header confirms it") {
    board.run(frame1("led") + frame1("ledOn"));
    CHECK(done == std::vector<std::string>{"led", "ledOn"});
  }
  SUBCASE("anything else forbids it") {
    board.run("fffe03ledOn");
    board.later(7);
    CHECK(done.empty());
  }
  SUBCASE("the rest may arrive later") {
    board.run("fffe03led");
    board.run("On");
    board.later(200);
    CHECK(done.empty());
  }
  SUBCASE("a shortened action with arguments is none") {
    board.run("fffe05speed(120)");
    board.later(200);
    CHECK(done.empty());
    board.run(frame1("speed"));
    board.later(7);
    CHECK(done == std::vector<std::string>{"speed 0 -1"});
  }
  SUBCASE("other names do not wait") {
    board.run(frame1("ledOn"));
    CHECK(done == std::vector<std::string>{"ledOn"});
    board.run(frame1("speed(3)"));
    CHECK(done.size() == 2);
  }
  SUBCASE("version 2 does not wait") {
    board.begin();
    board.run(command(0, "led"));
    CHECK(done == std::vector<std::string>{"led"});
  }
}

TEST_CASE("messages one by one") {
  Board board;
  CHECK(!board.javino.availableMsg());
  CHECK(board.javino.getMsg() == "");
  Serial.receive(frame1("ledOn") + frame1("getPercepts") + hello() + command(0, "say(1)"));
  CHECK(board.javino.availableMsg());
  CHECK(board.javino.getMsg() == "ledOn");
  CHECK(board.javino.getMsg() == "ledOn");
  CHECK(board.javino.requestAction("ledOn"));
  CHECK(!board.javino.requestAction("led"));
  CHECK(!board.javino.requestAction("ledOnX"));
  CHECK(!board.javino.requestPercepts());
  CHECK(board.javino.availableMsg());
  CHECK(board.javino.requestPercepts());
  CHECK(board.javino.getMsg() == "getPercepts");
  CHECK(!board.javino.requestAction("getPercepts"));
  CHECK(board.javino.sendMsg("a;b;"));
  CHECK(Serial.sent() == frame1("a;b;"));
  CHECK(board.javino.availableMsg());
  CHECK(board.javino.getMsg() == "say(1)");
  Serial.sent();
  CHECK(board.javino.sendMsg(String("done")));
  CHECK(Percepts().read(Serial.sent(), 0) == "done");
  CHECK(!board.javino.availableMsg());
  CHECK(Serial.sent() == ack(1));
}

TEST_CASE("a message may be refused") {
  Board board;
  board.begin();
  Serial.receive(command(0, "fly"));
  CHECK(board.javino.availableMsg());
  board.javino.refuse();
  CHECK(!board.javino.availableMsg());
  CHECK(Serial.sent() == ack(1, REFUSED));
}

TEST_CASE("the names of earlier libraries work, without start() too") {
  Javino javino;
  Serial.in.clear();
  Serial.sent();
  Serial.receive(frame1("ledOn"));
  CHECK(javino.availablemsg());
  CHECK(javino.getmsg() == "ledOn");
  javino.sendmsg("ok");
  CHECK(Serial.sent() == frame1("ok"));
}

TEST_CASE("percepts written beforehand go with the next answer, unless they are cleared") {
  Board board;
  board.javino.addPercept(String("a"));
  board.javino.clearPercepts();
  board.javino.addPercept(F("b(1)"));
  CHECK(board.run(frame1("getPercepts")) == frame1("b(1);"));
}

TEST_CASE("numbers, truth values and text as terms") {
  Board board;
  percepts_of = &board.javino;
  board.javino.perceive([] {
    percepts_of->percept("a", -5, 7L, 4000000000UL, true, static_cast<uint8_t>(200));
    percepts_of->percept("b", 1.5, -0.004, 2.999, -2.5f, "two words", String("x"));
    percepts_of->percept("c", 0.0 / 0.0, 1e30, -1e30, 4294967000.0);
    char buffer[] = "left";
    percepts_of->percept("d", F("in flash"), buffer);
    percepts_of->percept("e");
  });
  CHECK(board.run(frame1("getPercepts")) ==
        frame1("a(-5,7,4000000000,true,200);b(1.50,0.00,3.00,-2.50,\"two words\",x);"
               "c(nan,infinity,negative_infinity,4294967000.00);d(\"in flash\",left);e;"));
}

namespace {
int lost;
}

TEST_CASE("the lost link is reported") {
  Board board;
  lost = 0;
  board.javino.onLinkLost(500, [] { lost++; });
  board.later(400);
  CHECK(lost == 0);
  board.run(frame1("hello"));
  board.later(499);
  CHECK(lost == 0);
  board.later(2);
  CHECK(lost == 1);
  board.later(5000);
  CHECK(lost == 1);
  board.run(frame1("hello"));
  CHECK(!board.javino.availableMsg());
  stub_millis += 501;
  CHECK(!board.javino.availableMsg());
  CHECK(lost == 2);
  board.run(frame1("hello"));
  board.javino.onLinkLost(0, [] { lost++; });
  board.later(5000);
  CHECK(lost == 2);
}

namespace {
int depth, deepest;
std::string during;
JavinoLater gripper;
}

TEST_CASE("run() within a callback only receives") {
  static Javino *javino;
  Board board;
  javino = &board.javino;
  depth = deepest = 0;
  during.clear();
  board.javino.onAction("drive", [](const JavinoArguments &arguments) {
    deepest = std::max(deepest, ++depth);
    during += std::to_string(arguments.number(0)) + ":";
    Serial.receive(command(1, "drive(8)") + ask(1));
    javino->run();
    CHECK(!javino->availableMsg());
    stub_millis += 3000;
    javino->run();
    during += std::to_string(arguments.number(0)) + Serial.sent() + ";";
    depth--;
    return arguments.number(0) != 7;
  });
  board.begin();
  CHECK(hexOf(board.run(command(0, "drive(7)"))) == hexOf(ack(1, REFUSED) + ack(1, REFUSED) + frame2(0xC2, 1, "\x01")));
  CHECK(deepest == 1);
  CHECK(during == "7:7;");
}

TEST_CASE("what arrives within a callback that takes long is not lost, nor are silences in it") {
  static Javino *javino;
  Board board;
  javino = &board.javino;
  board.javino.act["ledOn"] = ledOn;
  board.javino.act["wait"] = [] {
    Serial.receive("fffe0Bnever");
    javino->run();
    stub_millis += 200;
    javino->run();
    Serial.receive(frame1("ledOn"));
    javino->run();
  };
  board.run(frame1("wait"));
  CHECK(done == std::vector<std::string>{"ledOn"});
}

TEST_CASE("a long action reports its outcome later, and the board goes on") {
  static Javino *javino;
  Board board;
  javino = &board.javino;
  board.javino.act["close"] = [] {
    done.push_back("close");
    gripper = javino->later();
  };
  board.begin();
  CHECK(board.run(command(0, "close")) == ack(0, BUSY));
  CHECK(board.later(500) == "");
  CHECK(board.run(command(0, "close")) == ack(0, BUSY));
  CHECK(board.run(ask(1)) == frame2(0xA2, 0, "\x01"));
  CHECK(board.javino.done(gripper));
  CHECK(Serial.sent() == ack(1));
  CHECK(board.run(command(0, "close")) == ack(1));
  CHECK(done.size() == 1);
  CHECK(board.run(command(1, "close")) == ack(1, BUSY));
  CHECK(board.javino.done(gripper, false));
  CHECK(Serial.sent() == ack(2, REFUSED));
  board.later(100);
  CHECK(board.run(frame1("close")) == "");
  CHECK(!board.javino.done(gripper));
  CHECK(Serial.sent() == "");
}

TEST_CASE("no frame is lost while loop() stalls") {
  for (unsigned long stall : {150, 300, 1000}) {
    Board board;
    board.javino.act["ledOn"] = ledOn;
    for (bool session : {false, true}) {
      if (session)
        board.begin();
      unsigned due = 0;
      for (size_t cut = 1; cut < 6; cut++) {
        const std::string frame = session ? command(due++, "ledOn") : frame1("ledOn");
        done.clear();
        board.run(frame.substr(0, cut));
        stub_millis += stall;
        board.run(frame.substr(cut));
        CHECK(done.size() == 1);
        board.later(200);
      }
    }
  }
}

TEST_CASE("a port that takes nothing is asked once for each message") {
  Board board;
  Serial.takes = false;
  Serial.refused = 0;
  board.run(frame1("getPercepts"));
  CHECK(Serial.refused == 1);
  board.run(frame1("getPercepts"));
  CHECK(Serial.refused == 2);
  Serial.takes = true;
  CHECK(board.run(frame1("getPercepts")) == frame1(""));
}

TEST_CASE("a quoted text is a string, whatever it is") {
  Board board;
  static Board *of;
  of = &board;
  board.javino.perceive([] { of->javino.percept("says", quoted("hi"), "hi", quoted("a \"b\""), quoted("")); });
  Serial.receive(frame1("getPercepts"));
  board.javino.run();
  CHECK(Serial.sent() == frame1("says(\"hi\",hi,\"a \\\"b\\\"\",\"\");"));
}

TEST_CASE("percepts have as many decimals as are asked for, and whole numbers of 64 bits") {
  static Board *of;
  Board board;
  of = &board;
  board.javino.perceive([] {
    of->javino.percept("gps", decimals(48.137154, 6), decimals(-0.5, 1), decimals(-0.04, 1));
    of->javino.percept("round", decimals(9.9999, 3), decimals(0.0009765625, 9), decimals(1.05, 0), decimals(4294967039.0, 1));
    of->javino.percept("none", decimals(0.0 / 0.0, 3), decimals(-1e30, 3));
    of->javino.percept("long", 9223372036854775807LL, -9223372036854775807LL - 1, 18446744073709551615ULL, 0LL);
  });
  CHECK(board.run(frame1("getPercepts")) ==
        frame1("gps(48.137154,-0.5,0.0);round(10.000,0.000976563,1.1,4294967039.0);none(nan,negative_infinity);"
               "long(9223372036854775807,-9223372036854775808,18446744073709551615,0);"));
}

TEST_CASE("numbers with decimals are read, and nothing else") {
  auto decimal = [](const std::string &text) {
    const std::string literal = "f(" + text + ")";
    return JavinoArguments(literal.data(), static_cast<uint8_t>(literal.size())).decimal(0, -77);
  };
  CHECK(decimal("0") == 0);
  CHECK(decimal("3.25") == 3.25);
  CHECK(decimal("-3.25") == -3.25);
  CHECK(decimal("+7") == 7);
  CHECK(decimal("1.0E10") == 1e10);
  CHECK(decimal("1e+3") == 1000);
  CHECK(decimal("25e-2") == 0.25);
  CHECK(decimal("0.1") == 0.1);
  CHECK(decimal("48.137154321") == 48.137154321);
  CHECK(decimal("123456789012345678901234567890") == doctest::Approx(123456789012345678901234567890.0));
  CHECK(decimal("0e400") == 0);
  CHECK(decimal("1e-400") == 0);
  for (const std::string &bad :
       {std::string("nan"), std::string("NAN"), std::string("inf"), std::string("infinity"), std::string("0x10"), std::string("1e400"),
        std::string("-1e400"), std::string("1e99999"), std::string("\"3.5\""), std::string("1\0x", 3), std::string("1\0", 2), std::string("x"),
        std::string("+"), std::string("-"), std::string("."), std::string("5."), std::string(".5"), std::string("1e"), std::string("1e+"),
        std::string("1.e5"), std::string("1.5.5"), std::string("--1"), std::string("1 2"), std::string(250, '9') + "e99"}) {
    INFO(bad);
    CHECK(decimal(bad) == -77);
  }
}

TEST_CASE("actions beyond the memory are reported, and those before them still work") {
  JavinoSized<JAVINO_MEMORY_MIN + 5 * 4 * sizeof(void *)> javino;
  Serial.in.clear();
  int added = 0;
  while (added < 50 && javino.onAction(added ? "other" : "ledOn", ledOn))
    added++;
  CHECK(added == 5);
  CHECK(javino.act.count() == 5);
  CHECK(javino.act.full());
  done.clear();
  Serial.receive(frame1("ledOn"));
  javino.run();
  CHECK(done.size() == 1);
}

/** Returns the payload of the WELCOME with which a board begins a session. */
std::string welcomeOf(JavinoBoard &board) {
  Serial.in.clear();
  Serial.sent();
  Serial.receive(hello(9));
  board.run();
  auto welcome = frames2(Serial.sent());
  REQUIRE(welcome.size() == 1);
  return welcome[0].payload;
}

TEST_CASE("of more actions than have numbers the others are left out, and told") {
  JavinoSized<JAVINO_MEMORY + 126 * 4 * sizeof(void *)> javino;
  for (int i = 0; i < 126; i++)
    CHECK(javino.onAction("ledOn", ledOn));
  CHECK(!javino.act.full());
  std::string before = welcomeOf(javino);
  CHECK(before.back() == 0);
  for (int i = 0; i < 3; i++) {
    CHECK(!javino.onAction("more", ledOn));
    javino.act[F("more")] = ledOn;
  }
  CHECK(javino.act.count() == 126);
  std::string after = welcomeOf(javino);
  CHECK(after.back() == 6);
  CHECK_MESSAGE(after[2] == before[2], "they take no memory: the longest payload stays");
}

TEST_CASE("an action whose name fits on no page of the vocabulary is left out, and told") {
  JavinoSized<JAVINO_MEMORY + 2000> javino;
  std::string longest(JAVINO_NAME_MAX, 'n'), longer = longest + 'n';
  CHECK(javino.onAction(longest.c_str(), ledOn));
  CHECK(!javino.act.full());
  CHECK(!javino.onAction(longer.c_str(), ledOn));
  CHECK(!javino.onAction(F(longer.c_str()), ledOn));
  CHECK(javino.onAction("ledOn", ledOn));
  CHECK(javino.act.full());
  CHECK(welcomeOf(javino).back() == 2);
  Serial.receive(describe(1));
  javino.run();
  Serial.receive(describe(2, 1));
  javino.run();
  auto pages = frames2(Serial.sent());
  REQUIRE(pages.size() == 2);
  CHECK(pages[0].payload == std::string{1, 0, 2, 0, octet(JAVINO_NAME_MAX)} + longest);
  CHECK(pages[1].payload == std::string{2, 1, 2, 0, 5} + "ledOn");
}

TEST_CASE("the count of actions that are left out does not wrap") {
  JavinoSized<JAVINO_MEMORY_MIN> javino;
  for (int i = 0; i < 300; i++)
    CHECK(!javino.onAction("more", ledOn));
  CHECK(javino.act.full());
  CHECK(octet(255) == welcomeOf(javino).back());
}

TEST_CASE("any size of memory keeps the actions' table aligned") {
  JavinoSized<JAVINO_MEMORY + 255 + 3> javino;
  Serial.in.clear();
  javino.act["ledOn"] = ledOn;
  done.clear();
  Serial.receive(frame1("ledOn"));
  javino.run();
  CHECK(done.size() == 1);
}

TEST_CASE("no function is no action") {
  Board board;
  board.javino.act["ledOn"] = NULL;
  board.begin();
  CHECK(board.run(command(0, "ledOn")) == ack(1, REFUSED));
}

namespace {

/** A board that is a class of the sketch: its functions find its members by the board that they are handed. */
struct Robot : Javino {
  int power = 0;

  explicit Robot(FakeSerial &port) : Javino(port) {
    perceive(look);
    onAction("power", setPower, 1);
    onAction("more", more);
    onAction("check", check);
    onAction("add", add);
    act["off"] = off;
    act[String("zero")] = off;
    onLinkLost(300, off);
    begin(9600);
  }

  static Robot &of(JavinoBoard &board) { return static_cast<Robot &>(board); }
  static void look(JavinoBoard &board) { board.percept("power", of(board).power); }
  static bool setPower(JavinoBoard &board, const JavinoArguments &arguments) {
    if (!arguments.isNumber(0))
      return false;
    of(board).power = static_cast<int>(arguments.number(0));
    return true;
  }
  static void add(JavinoBoard &board, const JavinoArguments &arguments) {
    for (uint8_t i = 0; i < arguments.count(); i++)
      of(board).power += static_cast<int>(arguments.number(i));
  }
  static void more(JavinoBoard &board) { of(board).power++; }
  static bool check(JavinoBoard &board) { return of(board).power > 0; }
  static void off(JavinoBoard &board) { of(board).power = 0; }
};

}  // namespace

TEST_CASE("functions are handed the board, so that one function does for several") {
  stub_millis = 5000;
  FakeSerial left_line, right_line;
  static Robot left(left_line), right(right_line);  // As in a sketch: their names last for ever.
  auto run = [](Robot &robot, FakeSerial &line, const std::string &bytes) {
    line.receive(bytes);
    robot.run();
    return line.sent();
  };
  run(left, left_line, frame1("power(3)"));
  run(right, right_line, frame1("power(5)") + frame1("add(10,20)") + frame1("more"));
  CHECK(run(left, left_line, frame1("getPercepts")) == frame1("power(3);"));
  CHECK(run(right, right_line, frame1("getPercepts")) == frame1("power(36);"));
  run(left, left_line, hello());
  CHECK(run(left, left_line, command(0, "check")) == ack(1));
  CHECK(run(left, left_line, command(1, "off")) == ack(2));
  CHECK(left.power == 0);
  CHECK(run(left, left_line, command(2, "check")) == ack(3, REFUSED));
  CHECK(run(left, left_line, frame2(0x31, 3, item("power(x)"))) == ack(4, REFUSED));
  CHECK(run(left, left_line, frame2(0x31, 4, item("power(1,2)"))) == ack(5, REFUSED));
  CHECK(run(left, left_line, frame2(0x31, 5, item("more(1)"))) == ack(6, REFUSED));
  CHECK(left.power == 0);
  run(right, right_line, frame1("zero") + frame1("power(7)"));
  CHECK(right.power == 7);
  stub_millis += 301;
  run(right, right_line, "");
  CHECK(right.power == 0);
}

TEST_CASE("functions are taken back by NULL, and lambdas take the board too") {
  Board board;
  board.javino.perceive([](JavinoBoard &of) { of.addPercept("seen"); });
  CHECK(board.run(frame1("getPercepts")) == frame1("seen;"));
  board.javino.perceive(NULL);
  board.javino.onLinkLost(0, NULL);
  CHECK(board.run(frame1("getPercepts")) == frame1(""));
  board.javino.act["led"] = [](JavinoBoard &) { done.push_back("led"); };
  CHECK(board.javino.onAction("on", [] { return false; }));
  board.begin();
  CHECK(board.run(command(0, "led")) == ack(1));
  CHECK(board.run(command(1, "on")) == ack(2, REFUSED));
  CHECK(done == std::vector<std::string>{"led"});
}

TEST_CASE("a function is called for unknown actions, which are refused or which it has carried out") {
  for (bool before : {true, false}) {
    Board board;
    auto unknown = [](JavinoBoard &, const char *action) { done.push_back(std::string("? ") + action); };
    if (before)
      board.javino.onUnknownAction(unknown);
    board.javino.act["ledOn"] = ledOn;
    board.javino.onAction("turn", turn, 2);
    if (!before)
      board.javino.onUnknownAction(unknown);
    board.run(frame1("fly") + frame1("turn(left)") + frame1("ledOn") + frame1("getPercepts"));
    CHECK(done == std::vector<std::string>{"? fly", "? turn(left)", "ledOn"});
    board.begin();
    done.clear();
    CHECK(board.run(command(0, "fly(\"a b\")")) == ack(1, REFUSED));
    CHECK(board.run(frame2(0x31, 1, item("turn(right,3)"))) == ack(2, REFUSED));  // by its own function
    CHECK(board.run(frame2(0x31, 2, item("turn(left,3)"))) == ack(3));
    CHECK(done == std::vector<std::string>{"? fly(\"a b\")", "turn 3"});
    CHECK(board.run(describe(1)) == frame2(0x86, 3, bytesOf("01 00 00")));
    board.javino.onUnknownAction([](JavinoBoard &, const char *action) { return strcmp(action, "fly") == 0; });
    CHECK(board.run(command(3, "fly")) == ack(4));
    CHECK(board.run(command(4, "swim")) == ack(5, REFUSED));
    board.javino.onUnknownAction(NULL);
    CHECK(board.run(frame2(0x31, 5, item("fly"))) == ack(6, REFUSED));
    CHECK(board.run(describe(2)).substr(0, 7) == frame2(0x86 | REFUSED, 6, bytesOf("02 00 02 00 05") + "ledOn" + "\2\4turn").substr(0, 7));
    CHECK(board.javino.act.count() == 2);
  }
}

TEST_CASE("texts may lie in flash") {
  Board board;
  board.javino.act[F("ledOn")] = ledOn;
  board.javino.act[F("off")] = [](JavinoBoard &) { done.push_back("off"); };
  CHECK(board.javino.onAction(F("turn"), turn, 2));
  CHECK(board.javino.onAction(F("is"), [](JavinoBoard &, const JavinoArguments &of) { return of.is(0, F("a b")) && !of.is(0, F("a")); }));
  board.javino.act[F("ledOn")]();
  board.javino.act["off"]();
  CHECK(board.javino.act.count() == 4);
  CHECK(done == std::vector<std::string>{"ledOn", "off"});
  board.javino.perceive([](JavinoBoard &of) {
    of.percept(F("light"), F("front"), F("a \"b\""), 3);
    of.percept(F("up"));
    if (of.wants(F("dark")))
      of.addPercept(F("dark(2)"));
  });
  CHECK(board.run(frame1("getPercepts")) == frame1("light(front,\"a \\\"b\\\"\",3);up;dark(2);"));
  CHECK(board.run(frame1("getPercepts(up)")) == frame1("up;"));
  board.begin();
  CHECK(board.run(command(0, "turn(left,3)")) == ack(1));
  CHECK(board.run(command(1, "is(\"a b\")")) == ack(2));
  CHECK(board.run(command(2, "ledOn")) == ack(3));
  CHECK(board.run(frame2(0x30, 3, "\x81")) == ack(4));
  CHECK(done == std::vector<std::string>{"ledOn", "off", "turn 3", "ledOn", "off"});
  Serial.receive(command(4, "later"));
  CHECK(board.javino.availableMsg());
  CHECK(board.javino.requestAction(F("later")));
  CHECK(!board.javino.requestAction(F("late")));
  CHECK(board.javino.sendMsg(F("told(1);")));
  // With a message in hand there is no room for a name.
  board.javino.act[F("more")] = ledOn;
  CHECK(board.javino.act.full());
  CHECK(!board.javino.onAction(F("more"), ledOn));
  CHECK(board.javino.act.count() == 4);
}

TEST_CASE("a sketch describes its percepts if it is asked to, in as many parts as its memory needs") {
  Board board;
  std::string all;
  for (int i = 0; i < 40; i++)
    all += "?light(front|back, % 0..100);";
  board.javino.perceive([](JavinoBoard &of) {
    of.percept("light", "front", 3);
    for (int i = 0; i < 40; i++)
      of.describe(F("light(front|back, % 0..100)"));
  });
  CHECK(board.run(frame1("getPercepts")) == frame1("light(front,3);"));
  board.begin();
  Percepts percepts;
  CHECK(percepts.read(board.run(ask(1, 0, "(?)")), 1) == all);
  CHECK(percepts.read(board.run(ask(2, 0)), 2) == "light(front,3);");
  CHECK(board.run(ask(3, 1)) == frame2(0x82, 0, bytesOf("03 80 01 3F")));
}

TEST_CASE("version 1: no function is called for what may be the beginning of an action") {
  Board board;
  board.javino.act["ledOn"] = ledOn;
  board.javino.onUnknownAction([](JavinoBoard &, const char *action) { done.push_back(action); });
  board.run(frame1("fly") + "(1)");
  board.later(200);
  CHECK(done.empty());
  board.run(frame1("fly"));
  board.later(7);
  CHECK(done == std::vector<std::string>{"fly"});
}

TEST_CASE("what arrives, what is damaged and how long loop() takes is counted") {
  for (bool watches : {false, true}) {
    Board board;
    JavinoCounters counters;
    board.javino.countInto(counters);
    if (watches)
      CHECK(board.javino.watchRules());
    board.javino.countInto(counters);
    board.javino.act["ledOn"] = ledOn;
    board.begin();
    board.run(command(0, "ledOn") + ask(1));
    std::string bad = ask(2);
    bad.back() = octet(bad.back() ^ 1);
    for (int i = 0; i < 300; i++)
      board.run(bad);
    stub_millis += 40;
    board.run("");
    stub_millis += 70;
    board.run(std::string(63, 'x'));
    stub_millis += 20;
    board.run(std::string(62, 'x'));
    CHECK(counters.frames == 3);
    CHECK(counters.damaged == 300);
    CHECK(counters.longestLoop == 70);
    CHECK(counters.overruns == 1);
    board.javino.act["slow"] = [] { stub_millis += 250; };
    stub_millis += 200;
    board.run(command(1, "slow"));
    CHECK(counters.longestLoop == 250);
    counters.longestLoop = 0;
    stub_millis += 5;
    board.run("");
    CHECK(counters.longestLoop == 5);
    CHECK(done == std::vector<std::string>{"ledOn"});
    if (watches) {
      board.run(frame2(0x30, 2, ruleItem(std::string("\1dist\0001<40\0\2ledOn", 17))));
      board.javino.perceive([](JavinoBoard &of) { of.percept("dist", 30); });
      board.later(10);
      CHECK(done.size() == 2);
    }
  }
}

namespace {

std::mt19937 chance(6);

/** Damages one byte in 200. @return true if any was */
bool damage(std::string &bytes) {
  bool damaged = false;
  for (char &c : bytes)
    if (chance() % 200 == 0) {
      c = static_cast<char>(c ^ (1 + chance() % 255));
      damaged = true;
    }
  return damaged;
}

}  // namespace

TEST_CASE("with one byte in 200 damaged no wrong action is carried out, and no intact message is lost") {
  // Most are the beginning of another.
  const std::vector<std::string> actions = {"led", "ledOn", "ledOnce", "go", "go(1)", "go(12)", "stop"};
  for (int version : {1, 2}) {
    Board board;
    board.javino.act["led"] = [] { done.push_back("led"); };
    board.javino.act["ledOn"] = [] { done.push_back("ledOn"); };
    board.javino.act["ledOnce"] = [] { done.push_back("ledOnce"); };
    board.javino.act["go(1)"] = [] { done.push_back("go(1)"); };
    board.javino.act["go(12)"] = [] { done.push_back("go(12)"); };
    board.javino.act["stop"] = [] { done.push_back("stop"); };
    board.javino.onAction("go", [](const JavinoArguments &arguments) {
      if (arguments.count() == 0)
        done.push_back("go");
      return arguments.count() == 0;
    });
    long carried = 0, damaged_actions = 0, wrong = 0, of_wrong_length = 0, lost_actions = 0, lost_requests = 0;
    const long sent = 200000;
    for (long i = 0; i < sent; i++) {
      const std::string &text = actions[chance() % actions.size()];
      // Before each a session of version 2 begins anew, so that each can be told from the others.
      if (version == 2)
        board.begin(static_cast<unsigned>(i % 250 + 1));
      std::string action = version == 1 ? frame1(text) : command(0, text);
      std::string request = version == 1 ? frame1("getPercepts") : ask(1);
      bool damaged = damage(action);
      damaged_actions += damaged;
      done.clear();
      // The request that follows at once is intact.
      bool at_once = chance() % 2;
      if (at_once)
        action += request;
      std::string answers = board.run(action);
      answers += board.later(10);
      answers += board.later(150);
      bool answered = answers.find(version == 1 ? "fffe00" : std::string("\x01\x82", 2)) != std::string::npos ||
                      answers.find("\x01\xC2") != std::string::npos;
      // A header damaged into the start of version 2 may take what follows.
      bool other_version = version == 1 && action.substr(0, 6).find('\xA5') != std::string::npos;
      lost_requests += at_once && !answered && !other_version;
      lost_actions += !damaged && done.empty();
      for (const std::string &carried_out : done) {
        carried++;
        wrong += carried_out != text;
        of_wrong_length += carried_out.size() != text.size();
      }
    }
    CHECK(damaged_actions > 5000);
    CHECK(of_wrong_length == 0);
    CHECK(lost_actions == 0);
    CHECK(lost_requests == 0);
    if (version == 2)
      CHECK(wrong == 0);
    printf("  version %d on the host: %ld actions sent, %ld damaged, %ld carried out, %ld other than sent,"
           " %ld of another length, %ld intact requests lost\n",
           version, sent, damaged_actions, carried, wrong, of_wrong_length, lost_requests);
  }
}
