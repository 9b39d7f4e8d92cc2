// The vectors of version 2 through the core: rows of commands, answers, vocabularies, conversations.

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "conversation.h"
#include "javino_literal.h"
#include "javino_rules.h"

using nlohmann::json;

namespace {

const json &vectors() {
  static const json all = json::parse(std::ifstream(VECTORS_2));
  return all;
}

/** The frames as the vectors have them: CC SS payload. */
std::vector<std::string> hexOfFrames(const std::string &bytes) {
  std::vector<std::string> all;
  for (const Frame2 &frame : frames2(bytes))
    all.push_back(hexOf(std::string{octet(frame.kind), octet(frame.number)} + frame.payload));
  return all;
}

/** A frame to the board, of CC SS payload; HELLO begins the session to which it and those behind it belong. */
std::string frameOf(const std::string &hex, unsigned &nonce) {
  std::string bytes = bytesOf(hex);
  if (bytes[0] == 0x10)
    nonce = session = static_cast<uint8_t>(bytes[1]);
  return frame2(static_cast<uint8_t>(bytes[0]), static_cast<uint8_t>(bytes[1]), bytes.substr(2), nonce);
}

/** The items of an answer, its parts put together. */
std::string itemsOf(const std::string &bytes) {
  std::string items;
  for (const Frame2 &frame : frames2(bytes))
    items += frame.payload.substr(frame.kind == 0x82 ? 1 : 2);
  return items;
}

bool endsPercepts(const json &texts) {
  return std::all_of(texts.begin(), texts.end(), [](const json &t) { return t.get<std::string>().back() == ';'; });
}

/** A board of the vectors and its program. */
struct Program : Conversation {
  std::set<std::string> refuses, reports_later;
  std::vector<std::string> texts, kinds;
  std::vector<std::string> answers; /* to messages of version 1 */
  json carried = json::array();
  javino_later pending = 0;

  explicit Program(const json &board) : Conversation(JAVINO_MEMORY + 600) {
    for (const json &action : board["actions"])
      actions.push_back({action[0], action[1]});
    for (const json &name : board["refuses"])
      refuses.insert(name);
    for (const json &name : board["later"])
      reports_later.insert(name);
    for (const json &kind : board.value("kinds", json::array()))
      kinds.push_back(latin1(kind));
    REQUIRE(javino_rules_init(&this->board, 250, react, nullptr));
  }

  /** Returns true if the program has such an action and takes the arguments. */
  bool takes(const std::string &text) const {
    const uint8_t length = static_cast<uint8_t>(text.size());
    const std::string name = text.substr(0, javino_functor(text.data(), length));
    const char *argument;
    uint8_t count = 0;
    while (!name.empty() && javino_argument(text.data(), length, count, &argument))
      count++;
    for (const auto &action : actions)
      if (action.first == name)
        return action.second == JAVINO_ANY || action.second == count;
    return false;
  }

  /** Carries an action out. @return false if it is refused */
  bool carryOut(const std::string &name) {
    if (!takes(name) || refuses.count(name))
      return false;
    carried.push_back(name);
    return true;
  }

  static bool react(void *self, const char *text, uint8_t length) {
    return static_cast<Program *>(static_cast<Conversation *>(self))->carryOut(std::string(text, length));
  }

  static void perceive(void *self) { static_cast<Program *>(static_cast<Conversation *>(self))->writePercepts(); }

  void act() {
    const std::string name = text();
    if (!carryOut(name))
      finish(false);
    else if (reports_later.count(name))
      pending = javino_link_later(&board.link);
  }

  void writePercepts() {
    for (const std::string &kind : kinds)
      if (javino_kind_begin(&board))
        percept(kind);
    for (const std::string &text : texts) {
      std::string functor = text.substr(0, text.find_first_of("(;"));
      if (javino_board_wants(&board, functor.data(), functor.size()))
        percept(text.substr(0, text.size() - 1));
    }
  }

  void answer() {
    writePercepts();
    javino_board_answer(&board);
  }

  void run() {
    javino_event event;
    while ((event = poll()) != JAVINO_NOTHING || board.answering)
      if (event != JAVINO_NOTHING)
        event == JAVINO_REQUEST ? answer() : act();
  }

  void take(const json &step) {
    if (step.contains("percepts")) {
      texts.clear();
      for (const json &text : step["percepts"])
        texts.push_back(latin1(text));
    }
    for (const json &message : step.value("messages", json::array())) {
      now = static_cast<uint16_t>(now + 200);
      receive(frame1(latin1(message)));
      run();
    }
    answers = payloads1(sent());
    unsigned nonce = step.value("nonce", session);
    for (const json &hex : step.value("to", json::array())) {
      receive(frameOf(hex, nonce));
      run();
    }
    if (step.value("look", false)) {
      now = static_cast<uint16_t>(now + JAVINO_RULES_MS);
      javino_rules_look(&board, perceive, now);
    }
    if (step.contains("report"))
      javino_link_done(&board.link, pending, step["report"] == "done");
    if (step.value("unasked", false) && board.link.session != 0)
      answer();
  }
};

}  // namespace

namespace {

/** The commands that a row hands out, rules among them. */
struct Row : Conversation {
  json found = json::array();
  unsigned before = 0;

  Row() {
    board.link.rules_max = 1;
    board.rule = takeRule;
  }

  /** Those in front of the command that is due have been used up without a command. */
  void note(unsigned due) {
    for (; before < due; before++)
      found.push_back(nullptr);
  }

  void take(const json &command) {
    note(board.link.due);
    found.push_back(command);
    before++;
  }

  static bool takeRule(javino_board *board, uint8_t where) {
    Row *self = static_cast<Row *>(static_cast<Conversation *>(board->link.encoder.context));
    if (where == JAVINO_RULES_SET)
      self->take({{"rule", hexOf(self->text())}});
    return false;
  }
};

/** As the vectors have it, but with texts as bytes. */
json inHex(const json &command) {
  if (command.is_object())
    return {{"rule", hexOf(latin1(command["rule"]))}};
  return command.is_string() ? json(hexOf(latin1(command))) : command;
}

}  // namespace

TEST_CASE("rows of commands are read as in the vectors") {
  for (const json &c : vectors()["commands"]) {
    INFO(c["name"]);
    Row board;
    for (int i = 0; i < 126; i++)
      board.actions.push_back({"action" + std::to_string(i), 0});
    board.begin();
    board.receive(frame2(0x30, 0, bytesOf(c["payloadHex"])));
    while (board.poll() == JAVINO_ACTION) {
      std::string text = board.text();
      board.take(text.compare(0, 6, "action") == 0 ? json(std::stoi(text.substr(6))) : json(hexOf(text)));
    }
    board.note(frames2(board.sent()).back().number);
    json expected = json::array();
    for (const json &command : c["commands"])
      expected.push_back(inHex(command));
    CHECK(board.found == expected);
  }
}

TEST_CASE("answers are coded as in the vectors") {
  int compared = 0;
  for (const json &c : vectors()["percepts"]) {
    INFO(c["name"]);
    Conversation board(JAVINO_MEMORY + 600);
    board.begin();
    unsigned request = 0;
    for (const json &answer : c["answers"]) {
      if (!endsPercepts(answer["texts"]))
        break;
      board.hear(ask(++request, answer["known"]));
      std::string all;
      bool whole = true;
      for (const json &text : answer["texts"]) {
        std::string percept = latin1(text);
        all += percept;
        whole = whole && percept.size() <= 250;
        board.percept(percept.substr(0, percept.size() - 1));
      }
      javino_board_answer(&board.board);
      std::string bytes = board.sent();
      CHECK(board.percepts.read(bytes, request) == all);
      // Another table, or a longer memory, would give other items for the same text.
      if (whole && c["shapes"] == 126 && answer["texts"].size() < JAVINO_SHAPES) {
        CHECK(hexOf(itemsOf(bytes)) == answer["itemsHex"]);
        compared++;
      }
    }
  }
  CHECK(compared > 40);
}

TEST_CASE("vocabularies are sent as in the vectors") {
  for (const json &c : vectors()["vocabulary"]) {
    INFO(c["name"]);
    if (c["room"] != 252)
      continue;
    Conversation board;
    size_t total = 0;
    for (const json &page : c["pages"]) {
      // The actions of all pages are the board's.
      size_t first = page["first"];
      for (const json &action : page["actions"])
        if (first++ == total) {
          board.actions.push_back({latin1(action[0]), action[1]});
          total++;
        }
    }
    board.begin();
    for (const json &page : c["pages"]) {
      board.hear(describe(page["request"], page["first"]));
      auto frames = frames2(board.sent());
      REQUIRE(frames.size() == 1);
      CHECK(hexOf(frames[0].payload) == page["payloadHex"]);
    }
  }
}

TEST_CASE("conversations with a board run as in the vectors") {
  int cases = 0;
  for (const json &c : vectors()["board"]) {
    INFO(c["name"]);
    cases++;
    auto program = std::make_unique<Program>(c["board"]);
    for (const json &step : c["steps"]) {
      if (step.value("restart", false))
        program = std::make_unique<Program>(c["board"]);
      program->carried = json::array();
      program->take(step);
      std::vector<std::string> found = hexOfFrames(program->sent());
      std::vector<std::string> expected = step["from"];
      if (step.value("look", false)) {
        // The board may look at several rules in any order.
        std::sort(found.begin(), found.end());
        std::sort(expected.begin(), expected.end());
      }
      REQUIRE(found.size() == expected.size());
      for (size_t i = 0; i < found.size(); i++) {
        // Of WELCOME only the nonce is compared: the rest describes the board.
        size_t compared = (bytesOf(expected[i])[0] & 0x9F) == 0x80 ? 6 : std::string::npos;
        CHECK(found[i].substr(0, compared) == expected[i].substr(0, compared));
      }
      CHECK(program->carried == step.value("carried", json::array()));
      CHECK(program->answers == step.value("answers", std::vector<std::string>()));
    }
  }
  CHECK(cases > 35);
}

TEST_CASE("rules are met as in the vectors") {
  for (const json &c : vectors()["rules"]) {
    INFO(c["name"]);
    Program program(vectors()["board"][0]["board"]);
    const std::string rule = latin1(c["command"]);
    program.begin();
    program.receive(frame2(0x30, 0, ruleItem(rule)));
    program.run();
    CHECK(program.sent() == ack(1, c["met"].is_null() ? REFUSED : 0));
    if (c["met"].is_null())
      continue;
    for (size_t i = 0; i < c["percepts"].size(); i++) {
      INFO(c["percepts"][i]);
      // It is set anew, so that it was not met before.
      program.receive(frame2(0x31, static_cast<unsigned>(i + 1), ruleItem(rule)));
      program.run();
      program.sent();
      program.texts = {latin1(c["percepts"][i])};
      program.now = static_cast<uint16_t>(program.now + JAVINO_RULES_MS);
      javino_rules_look(&program.board, Program::perceive, program.now);
      CHECK(program.sent().empty() != c["met"][i].get<bool>());
    }
  }
}
