// Critical rules on the board, as sketches and programs use them.

#include <Javino.h>

#include <algorithm>
#include <vector>

#include "conversation.h"
#include "javino_rules.h"

namespace {

std::string rule(unsigned number, const std::string &functor, const std::vector<std::string> &conditions = {},
                 const std::string &reflex = "") {
  std::string text = std::string(1, octet(number)) + functor + '\0';
  for (const std::string &condition : conditions)
    text += condition + '\0';
  return reflex.empty() ? text : text + '\x02' + reflex;
}

std::string critical(unsigned due, unsigned number, unsigned outcome, const std::string &percept) {
  return frame2(0x85, due, std::string{octet(number), octet(outcome)} + percept);
}

Javino *robot;
int distance, looks, stops;

void look() {
  looks++;
  if (robot->wants("light"))
    robot->percept("light", 512);
  if (robot->wants("dist"))
    robot->percept("dist", "f", distance);
}

void stop() {
  stops++;
  robot->addPercept("stopped");
}

/** A robot that watches rules, in a session. */
struct Robot {
  Javino javino;
  unsigned due = 0;

  Robot() {
    robot = &javino;
    distance = 100;
    looks = stops = 0;
    Serial.in.clear();
    Serial.meanwhile.clear();
    Serial.sent();
    javino.act["stop"] = stop;
    javino.perceive(look);
    REQUIRE(javino.watchRules());
    javino.start(9600);
    javino.run();
    CHECK(run(hello()) == frame2(0x80, 0, std::string{7, JAVINO_CREDIT, octet(255), JAVINO_RULES_MAX, 1, 0}));
  }

  std::string run(const std::string &bytes, unsigned long ms = 0) {
    stub_millis += ms;
    Serial.receive(bytes);
    javino.run();
    return Serial.sent();
  }

  std::string set(const std::string &text) { return run(frame2(0x30, due++, ruleItem(text))); }

  bool takes(const std::string &text) {
    std::string said = set(text);
    return said == ack(due);
  }
};

}  // namespace

TEST_CASE("a reflex is carried out and told once, each time that its rule begins to be met") {
  Robot r;
  CHECK(r.run("", 100) == "");
  CHECK(looks == 0);
  CHECK(r.set(rule(3, "dist", {"1=f", "2<40"}, "stop")) == ack(1));
  CHECK(r.run("", 5) == "");
  CHECK(looks >= 1);
  for (int turn = 0; turn < 3; turn++) {
    distance = 39;
    CHECK(r.run("", 5) == critical(1, 3, 1, "dist(f,39);"));
    CHECK(stops == turn + 1);
    CHECK(r.run("", 5) == "");
    distance = 40;
    CHECK(r.run("", 5) == "");
  }
  distance = 10;
  CHECK(r.run("", 4) == "");
  CHECK(r.run("", 1) == critical(1, 3, 1, "dist(f,10);"));
  // Percepts that the reflex has written go with the next answer.
  Percepts percepts;
  std::string answer = r.run(ask(1, 0, "(light)"));
  for (int i = 0; i < 9; i++)
    answer += r.run("");
  CHECK(percepts.read(answer, 1) == "stopped;stopped;stopped;stopped;light(512);");
}

TEST_CASE("actions may be named before and behind the call that has rules watched") {
  Javino javino;
  stops = 0;
  Serial.in.clear();
  Serial.meanwhile.clear();
  javino.act["first"] = stop;
  REQUIRE(javino.watchRules());
  javino.act["second"] = stop;
  robot = &javino;
  for (const char *name : {"first", "second", "first"}) {
    Serial.receive(frame1(name));
    javino.run();
    stub_millis += 1000;
    javino.run();
  }
  CHECK(stops == 3);
}

TEST_CASE("an unknown reflex and none are told") {
  Robot r;
  r.set(rule(1, "dist", {"2<40"}, "fly"));
  r.set(rule(2, "dist", {"2<30"}));
  distance = 35;
  CHECK(r.run("", 5) == critical(2, 1, 2, "dist(f,35);"));
  distance = 25;
  CHECK(r.run("", 5) == critical(2, 2, 0, "dist(f,25);"));
}

TEST_CASE("rules find room as far as there is memory, and replace those of their number") {
  Robot r;
  unsigned number = 1;
  while (number < 20 && r.takes(rule(number, "dist", {"2<40"}, "stop")))
    number++;
  CHECK(number > 4);
  CHECK(number <= JAVINO_RULES_MAX + 1);
  r.run(frame2(0x31, r.due, ruleItem(rule(1, "dist", {"2<99"}, "stop"))));
  r.due++;
  CHECK(r.takes("\x02"));
  CHECK(r.takes(rule(2, "dist", {"2<40"}, "stop")));
  CHECK(r.takes(std::string(1, '\0')));
  distance = 1;
  CHECK(r.run("", 5) == "");
}

TEST_CASE("a board that does not watch rules refuses them") {
  Javino javino;
  Serial.in.clear();
  Serial.receive(hello() + frame2(0x30, 0, ruleItem(rule(1, "dist"))));
  Serial.sent();
  javino.run();
  CHECK(Serial.sent() == frame2(0x80, 0, std::string{7, JAVINO_CREDIT, octet(255), 0, 1, 0}) + ack(1, REFUSED));
}

namespace {

/** A board without Arduino whose line a test sets free. */
struct Watcher : Conversation {
  std::vector<std::string> readings, carried;
  bool free = true;

  explicit Watcher(uint16_t bytes = JAVINO_MEMORY + 255) : Conversation(bytes / 8 * 8) {
    REQUIRE(javino_rules_init(&board, 96, react, is_free));
    begin();
  }

  static Watcher *of(void *self) { return static_cast<Watcher *>(static_cast<Conversation *>(self)); }
  static bool is_free(void *self) { return of(self)->free; }
  static bool react(void *self, const char *text, uint8_t length) {
    of(self)->carried.push_back(std::string(text, length));
    return true;
  }
  static void perceive(void *self) {
    for (const std::string &reading : of(self)->readings)
      of(self)->percept(reading);
  }

  void set(const std::string &text) {
    hear(frame2(0x30, board.link.due, ruleItem(text)));
    sent();
  }

  std::string look() {
    now += JAVINO_RULES_MS;
    javino_rules_look(&board, perceive, now);
    return sent();
  }
};

}  // namespace

TEST_CASE("while rules are set an answer goes out in short parts, and what is critical between them") {
  Watcher w;
  w.set(rule(1, "dist", {"1<40"}, "stop"));
  w.hear(ask(1));
  std::string all;
  for (int i = 0; i < 12; i++) {
    w.percept("light(" + std::to_string(i) + "00)");
    all += "light(" + std::to_string(i) + "00);";
  }
  javino_board_answer(&w.board);
  std::string answer = w.sent();
  CHECK(answer == "");
  for (int turn = 0; w.board.answering; turn++) {
    w.free = false;
    w.poll();
    CHECK(w.sent() == "");
    w.readings = {turn % 2 ? "dist(50)" : "dist(3)"};
    CHECK(w.look() == (turn % 2 ? "" : critical(1, 1, 1, "dist(3);")));
    w.free = true;
    w.poll();
    std::string part = w.sent();
    CHECK(frames2(part)[0].payload.size() <= 14);
    answer += part;
    REQUIRE(turn < 50);
  }
  CHECK(w.percepts.read(answer, 1) == all);
}

TEST_CASE("commands are carried out while an answer goes out, and another request ends it") {
  Watcher w;
  w.set(rule(1, "dist", {"1<40"}));
  w.hear(ask(1));
  w.percept("light(100,200,300,400)");
  w.percept("temp(100,200,300,400,500,600)");
  javino_board_answer(&w.board);
  CHECK(w.hear(command(1, "front")) == JAVINO_ACTION);
  CHECK(w.poll() == JAVINO_NOTHING);
  w.now += 30;
  w.poll();
  // Unasked percepts go with the answer on its way.
  CHECK(w.percept("bumped"));
  CHECK(w.hear(ask(2)) == JAVINO_REQUEST);
  std::string answer;
  for (const Frame2 &frame : frames2(w.sent()))
    if (frame.kind != 0x81)
      answer += frame2(frame.kind, frame.number, frame.payload);
  CHECK(w.percepts.read(answer, 1) == "light(100,200,300,400);temp(100,200,300,400,500,600);bumped;");
  w.percept("light(1,2,3,4)");
  javino_board_answer(&w.board);
  while (w.board.answering)
    w.poll();
  CHECK(w.percepts.read(w.sent(), 2) == "light(1,2,3,4);");
}

TEST_CASE("parts of an answer that have not gone out when a session begins are dropped") {
  Watcher w;
  w.set(rule(1, "dist", {"1<40"}));
  w.hear(ask(1));
  w.percept("light(100,200,300,400)");
  javino_board_answer(&w.board);
  w.begin(8);
  w.poll();
  CHECK(w.sent() == "");
  CHECK(w.hear(ask(1)) == JAVINO_REQUEST);
  w.percept("light(1,2,3,4)");
  CHECK(w.answered(1) == "light(1,2,3,4);");
}

TEST_CASE("on a board as small as an Uno a long command finds room while an answer goes out") {
  Watcher w(368);
  w.set(rule(1, "dist", {"1<40"}));
  w.hear(ask(1));
  w.percept("light(100,200,300,400)");
  javino_board_answer(&w.board);
  REQUIRE(w.board.answering);
  CHECK(w.hear(command(1, "say(" + std::string(100, 'x') + ")")) == JAVINO_ACTION);
}

TEST_CASE("on a board as small as an Uno rules are watched while a long answer goes out") {
  Watcher w(368);
  w.set(rule(1, "dist", {"1<40"}));
  w.hear(ask(1));
  for (int i = 0; i < 12; i++)
    w.percept(std::string(1, static_cast<char>('a' + i)) + "light(100)");
  javino_board_answer(&w.board);
  REQUIRE(w.board.length > 120);
  w.sent();
  w.readings = {"dist(front,3)", "dist(3)"};
  CHECK(w.look() == critical(1, 1, 0, "dist(3);"));
}

TEST_CASE("while rules are set an answer that does not fit takes the line no longer than for what does not fit") {
  Watcher w(368);
  w.set(rule(1, "dist", {"1<40"}, "stop"));
  w.hear(ask(1));
  const size_t room = w.board.room;
  std::string all;
  for (int i = 0; i < 20; i++) {
    w.percept(std::string(1, static_cast<char>('a' + i)) + "light(100)");
    all += std::string(1, static_cast<char>('a' + i)) + "light(100);";
  }
  javino_board_answer(&w.board);
  std::string answer = w.sent();
  CHECK(answer.size() > 0);
  const size_t fits = room / 12;  // parts of twelve bytes in frames of twenty
  CHECK(answer.size() <= (20 * 14 / 12 + 1 - fits) * 20);
  w.readings = {"dist(3)"};
  CHECK(w.look() == critical(1, 1, 1, "dist(3);"));
  for (int turn = 0; w.board.answering; turn++) {
    w.poll();
    answer += w.sent();
    REQUIRE(turn < 50);
  }
  CHECK(w.percepts.read(answer, 1) == all);
}

TEST_CASE("while rules are set an answer in version 1 is messages of whole percepts all the same") {
  Watcher w(368);
  w.set(rule(1, "dist", {"1<40"}, "stop"));
  w.now += 200;
  w.poll();
  REQUIRE(w.hear(frame1("getPercepts")) == JAVINO_REQUEST);
  std::string all;
  for (int i = 0; i < 30; i++) {
    w.percept(std::string(1, static_cast<char>('a' + i % 26)) + "light(1000)");
    all += std::string(1, static_cast<char>('a' + i % 26)) + "light(1000);";
  }
  javino_board_answer(&w.board);
  std::string answer;
  std::vector<std::string> messages = payloads1(w.sent());
  CHECK(messages.size() > 1);
  CHECK(messages[0].size() > 100);
  for (const std::string &message : messages) {
    CHECK(message.size() % 13 == 0);
    CHECK(message.back() == ';');
    answer += message;
  }
  CHECK(answer == all);
}

TEST_CASE("while another request has an answer end, rules are watched between its parts") {
  Watcher w;
  w.set(rule(1, "dist", {"1<40"}, "stop"));
  w.look();
  w.hear(ask(1));
  std::string all;
  for (int i = 0; i < 12; i++) {
    w.percept("light(" + std::to_string(i) + "00)");
    all += "light(" + std::to_string(i) + "00);";
  }
  javino_board_answer(&w.board);
  w.readings = {"dist(3)"};
  CHECK(w.hear(ask(2)) == JAVINO_REQUEST);
  CHECK(w.carried == std::vector<std::string>{"stop"});
  std::vector<Frame2> frames = frames2(w.sent());
  REQUIRE(frames.size() > 5);
  CHECK(std::min(frames[1].kind, frames[2].kind) == 0x83);
  CHECK(std::max(frames[1].kind, frames[2].kind) == 0x85);
  std::string answer;
  for (const Frame2 &frame : frames)
    if (frame.kind != 0x85)
      answer += frame2(frame.kind, frame.number, frame.payload);
  CHECK(w.percepts.read(answer, 1) == all);
  w.percept("light(1)");
  CHECK(w.answered(2) == "light(1);");
}

TEST_CASE("a percept of more than 253 bytes meets no rule") {
  Watcher w(1000);
  w.set(rule(1, "say"));
  auto percept = [](size_t size) { return "say(\"" + std::string(size - 8, 'x') + "\")"; };
  w.readings = {percept(254)};
  CHECK(w.look() == "");
  w.readings = {percept(253)};
  CHECK(w.look() == critical(1, 1, 0, percept(253) + ";"));
}

TEST_CASE("percepts that wait are not disturbed by looking at the rules") {
  Watcher w;
  w.set(rule(1, "dist", {"1<40"}));
  w.percept("bumped(1)");
  w.readings = {"dist(3)", "dist(4)", "dist(90)"};
  CHECK(w.look() == critical(1, 1, 0, "dist(3);"));
  w.percept("bumped(2)");
  CHECK(w.look() == "");
  w.hear(ask(1));
  javino_board_answer(&w.board);
  while (w.board.answering)
    w.poll();
  CHECK(w.percepts.read(w.sent(), 1) == "bumped(1);bumped(2);");
  CHECK(w.board.link.decoder.size == JAVINO_WINDOW);
}
