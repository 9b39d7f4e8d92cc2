// Percepts and answers, in both versions.

#include <random>

#include "conversation.h"

TEST_CASE("each text crosses the line once, and digits alone from then on") {
  Conversation c;
  c.begin();
  c.hear(ask(1));
  c.percept("dist(f,123)");
  c.percept("light(f,95)");
  javino_board_answer(&c.board);
  CHECK(c.sent() == frame2(0x82, 0, "\x01" + bytesOf("000c") + "dist(f,123);" + bytesOf("010c") + "light(f,95);"));
  c.hear(ask(2, 2));
  c.percept("dist(f,123)");
  c.percept("light(f,95)");
  javino_board_answer(&c.board);
  CHECK(c.sent() == frame2(0x82, 0, "\x02" + bytesOf("8002123F95FF")));
}

TEST_CASE("what a computer reads is what the program has written, whatever it knows") {
  std::mt19937 random(11);
  const std::string shapes[] = {"dist(f,#)", "dist(b,#)", "light(f,-#.#)", "door(open)", "say(\"#;#\")", "p(#)",
                                "t(\xA4,#,\xA5)", "~x(#,#,#)", "z"};
  for (uint16_t bytes : {JAVINO_MEMORY_MIN, JAVINO_MEMORY, JAVINO_MEMORY + 255}) {
    Conversation c(bytes);
    c.begin();
    for (unsigned round = 1; round < 2000; round++) {
      unsigned number = round % 255 + 1;
      unsigned known = random() % 20 ? c.percepts.known() : 0;
      if (random() % 50 == 0)
        c.begin(round % 200 + 1), known = 0;
      REQUIRE(c.hear(ask(number, known)) == JAVINO_REQUEST);
      std::string all;
      for (size_t n = random() % (random() % 5 ? 14 : 60); n > 0; n--) {
        std::string percept;
        for (char ch : shapes[random() % 9])
          if (ch != '#')
            percept += ch;
          else
            for (size_t k = random() % 5 + 1; k > 0; k--)
              percept += static_cast<char>('0' + random() % 10);
        all += percept + ";";
        REQUIRE(c.percept(percept));
      }
      javino_board_answer(&c.board);
      std::string bytes_sent = c.sent();
      REQUIRE(c.percepts.read(bytes_sent, number) == all);
      c.poll();
    }
  }
}

TEST_CASE("twelve percepts take 33 bytes when their texts are known") {
  Conversation c;
  c.begin();
  for (unsigned round = 1; round < 3; round++) {
    c.hear(ask(round, c.percepts.known()));
    for (char side : std::string("fbrl"))
      for (const char *what : {"dist", "light", "temp"})
        c.percept(std::string(what) + "(" + side + "," + (*what == 't' ? "23" : "120") + ")");
    javino_board_answer(&c.board);
    std::string answer = c.sent();
    c.percepts.read(answer, round);
    if (round == 2)
      CHECK(answer.size() == 6 + 1 + 2 + (4 * (4 + 4 + 3) + 1) / 2);
  }
}

TEST_CASE("a shape beyond the table is sent as text") {
  Conversation c;
  c.begin();
  for (unsigned round = 1; round < 4; round++) {
    c.hear(ask(round, c.percepts.known()));
    std::string all;
    for (int i = 0; i < JAVINO_SHAPES + 3; i++) {
      std::string percept = std::string(1, static_cast<char>('a' + i % 26)) + std::string(i / 26, 'x') + "(" + std::to_string(i) + ")";
      CHECK(c.percept(percept));
      all += percept + ";";
    }
    CHECK(c.answered(round) == all);
  }
  CHECK(c.percepts.known() == JAVINO_SHAPES);
}

TEST_CASE("what the computer claims to know beyond what was sent is not believed") {
  Conversation c;
  c.begin();
  c.hear(ask(1, 200));
  c.percept("dist(f,1)");
  CHECK(c.answered(1) == "dist(f,1);");
}

TEST_CASE("a request that names functors is answered with those only") {
  Conversation c;
  c.begin();
  c.hear(ask(1, 0, "(dist,light)"));
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
  CHECK(c.answered(1) == "dist(f,1);");
  c.poll();
  c.now += 26;
  CHECK(c.hear(frame1("getPercepts(light)")) == JAVINO_REQUEST);
  CHECK(!wants("dist"));
  CHECK(wants("light"));
  c.hear(ask(2));
  CHECK(wants("temp"));
  c.poll();
  CHECK(wants("temp"));
}

TEST_CASE("percepts too many for one frame: version 2 sends parts") {
  for (int percepts : {0, 1, 25, 26, 27, 60, 300}) {
    Conversation c;
    c.begin();
    c.hear(ask(1));
    std::string all;
    for (int i = 0; i < percepts; i++) {
      c.percept("abcdefg");
      all += "abcdefg;";
    }
    CHECK(c.answered(1) == all);
  }
}

TEST_CASE("a percept longer than a frame: version 1 leaves it out and keeps the others, version 2 sends it") {
  for (size_t size : {30, 60, 100, 240, 250, 251, 252, 253, 254, 255, 256, 400, 600, 1000}) {
    std::string huge = "say(\"" + std::string(size, '7') + "\")";
    for (uint16_t bytes : {JAVINO_MEMORY_MIN, JAVINO_MEMORY, JAVINO_MEMORY + 255}) {
      INFO(size, " ", bytes);
      Conversation c(bytes);
      c.hear(frame1("getPercepts"));
      CHECK(c.percept("a"));
      bool fits = c.percept(huge);
      if (size > 255)
        CHECK(!fits);
      CHECK(c.percept("b"));
      javino_board_answer(&c.board);
      std::string together;
      for (const std::string &payload : payloads1(c.sent()))
        together += payload;
      CHECK(together == (fits ? "a;" + huge + ";b;" : "a;b;"));
#if JAVINO_TEXT_MAX == 255
      // There a percept may fill the memory.
      if (size > 30)
        continue;
#endif
      c.begin();
      for (unsigned round = 1; round < 4; round++) {
        c.hear(ask(round, c.percepts.known()));
        c.percept("a(1)");
        CHECK(c.percept(huge));
        c.percept("a(2)");
        CHECK(c.percept(huge));
        CHECK(c.answered(round) == "a(1);" + huge + ";a(2);" + huge + ";");
      }
    }
  }
}

TEST_CASE("without a request percepts wait, as many as there is memory for, and go with the next answer") {
  for (unsigned version : {1, 2}) {
    Conversation c;
    int kept = 0;
    while (c.percept("event(" + std::to_string(kept + 10) + ")") && kept < 1000)
      kept++;
    CHECK(kept == 255 / 12);
    CHECK(c.sent() == "");
    const std::string last = "event(" + std::to_string(kept + 9) + ");";
    if (version == 1) {
      c.hear(frame1("getPercepts"));
      javino_board_answer(&c.board);
      CHECK(payloads1(c.sent()).back().find(last) != std::string::npos);
    } else {
      c.begin();
      c.hear(ask(1));
      c.percept("now(1)");
      std::string answer = c.answered(1);
      CHECK(answer.find(last + "now(1);") != std::string::npos);
    }
  }
}

TEST_CASE("percepts that wait in a session survive the next one") {
  Conversation c;
  c.begin();
  c.percept("bumped(1)");
  c.percept("bumped(2)");
  c.begin(8);
  c.hear(ask(1));
  c.percept("dist(f,3)");
  CHECK(c.answered(1) == "bumped(1);bumped(2);dist(f,3);");
  c.hear(ask(2, 2));
  c.percept("dist(f,4)");
  CHECK(c.answered(2) == "dist(f,4);");
}

TEST_CASE("percepts unasked are sent with the number 0, and in numbers when their texts are known") {
  Conversation c;
  c.begin();
  c.percept("a(1)");
  CHECK(c.answered(0) == "a(1);");
  c.hear(ask(1));
  c.percept("a(1)");
  CHECK(c.answered(1) == "a(1);");
  c.hear(ask(2, 1));
  c.percept("a(2)");
  CHECK(c.answered(2) == "a(2);");
  c.poll();
  c.percept("a(31)");
  c.percept("a(4)");
  javino_board_answer(&c.board);
  CHECK(c.sent() == frame2(0x82, 0, bytesOf("00 80 01 31FF 80 01 4F")));
  CHECK(javino_board_send(&c.board, "say(1);b", 8));
  CHECK(c.percepts.read(c.sent(), 0) == "say(1);b");
}

TEST_CASE("without a session percepts unasked are a message of version 1") {
  Conversation c;
  c.percept("a(1)");
  javino_board_answer(&c.board);
  CHECK(c.sent() == frame1("a(1);"));
}

TEST_CASE("a message of any length is sent in parts") {
  for (size_t size : {0, 1, 251, 252, 502, 503, 2000}) {
    Conversation c;
    c.begin();
    c.hear(ask(1));
    std::string text(size, 'x');
    CHECK(javino_board_send(&c.board, text.data(), text.size()));
    CHECK(c.percepts.read(c.sent(), 1) == text);
    CHECK(javino_board_send(&c.board, "b", 1));
    CHECK(c.percepts.read(c.sent(), 0) == "b");
    javino_board_answer(&c.board);
    CHECK(c.sent() == "");
  }
}

TEST_CASE("percepts that wait do not keep requests and commands from arriving") {
  for (uint16_t bytes : {JAVINO_MEMORY_MIN, 255, 256, 300, 600})
    for (bool session : {false, true}) {
      Conversation c(bytes);
      if (session)
        c.begin();
      while (c.percept("event")) {
      }
      if (!session)
        c.hear(hello());
      CHECK(c.hear(command(0, "say(\"" + std::string(50, 'x') + "\")")) == JAVINO_ACTION);
      c.poll();
      c.sent();
      CHECK(c.hear(ask(1)) == JAVINO_REQUEST);
      CHECK(c.percept("dist(f,1)"));
      std::string answer = c.answered(1);
      CHECK(answer.substr(answer.size() - 22) == "event;event;dist(f,1);");
    }
}

TEST_CASE("percepts that nobody has asked for have all memory but what the longest frame needs") {
  for (uint16_t bytes : {JAVINO_MEMORY_MIN, JAVINO_MEMORY, 368, 640, 4000})
    for (unsigned version : {1, 2}) {
      INFO(bytes, " bytes, version ", version);
      Conversation c(bytes);
      if (version == 2)
        c.begin();
      std::string all;
      size_t used = 0;
      for (std::string percept; percept = "event(" + std::to_string(used) + ")", c.percept(percept); used += percept.size() + 3)
        all += percept + ";";
      size_t room = static_cast<size_t>(std::max(JAVINO_TEXT_MIN, bytes - JAVINO_WINDOW));
      room = std::min<size_t>(room, version == 1 ? 255 : JAVINO_TEXT_MAX);
      CHECK(used <= room);
      CHECK(used > room - 15);
      if (bytes >= JAVINO_MEMORY && version == 2) {
        CHECK(c.hear(frame2(0x30, 0, item(std::string(253, 'x')))) == JAVINO_ACTION);
        c.poll();
        c.sent();
      }
      if (version == 1) {
        c.hear(frame1("getPercepts"));
        javino_board_answer(&c.board);
        CHECK(payloads1(c.sent()) == std::vector<std::string>{all});
      } else if (bytes == 640) {
        CHECK(c.answered(0) == all);
      } else {
        c.hear(ask(1));
        CHECK(c.percept("more"));
        CHECK(c.answered(1) == all + "more;");
      }
      CHECK(c.percept("event"));
    }
}

TEST_CASE("what has waited for version 2 goes with an answer of version 1 too, unless it is more than that holds") {
  Conversation c(4000);
  c.begin();
  for (int i = 0; i < 20; i++)
    CHECK(c.percept("event"));
  c.now += 200;
  c.poll();
  c.hear(frame1("getPercepts"));
  std::string all;
#if JAVINO_TEXT_MAX == 255
  for (int i = 0; i < 20; i++)
    all += "event;";
#endif
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

TEST_CASE("a message that was begun and not sent makes no board deaf") {
  for (uint16_t bytes : {JAVINO_MEMORY_MIN, 272, 278, 300, JAVINO_MEMORY, 600, 4000})
    for (unsigned version : {1, 2})
      for (int percepts : {1, 5, 30, 100}) {
        Conversation c(bytes);
        if (version == 2)
          c.begin();
        auto request = [&](unsigned n) { return version == 1 ? frame1("getPercepts") : ask(n + 1); };
        const std::string say = "say(" + std::string(80, 'x') + ")";
        auto action = [&](unsigned n) { return version == 1 ? frame1(say) : command(n - 1, say); };
        INFO(bytes, " bytes, version ", version, ", ", percepts, " percepts");
        CHECK(c.hear(request(0)) == JAVINO_REQUEST);
        for (int i = 0; i < percepts; i++)
          c.percept("dist(front,120)");
        javino_percept_text(&c.board, "unfini");
        CHECK(c.poll() == JAVINO_NOTHING);
        c.sent();
        for (unsigned n = 1; n < 4; n++) {
          javino_event event = c.hear(action(n));
          if (version == 2 || bytes > JAVINO_MEMORY_MIN)
            REQUIRE(event == JAVINO_ACTION);
          c.poll();
          c.now += 200;
          c.poll();
          REQUIRE(c.hear(request(n)) == JAVINO_REQUEST);
          CHECK(c.percept("ready"));
          c.sent();
          javino_board_answer(&c.board);
          std::string answer = c.sent();
          CHECK(answer.find("ready;") != std::string::npos);
          CHECK(answer.find("unfini") == std::string::npos);
        }
      }
}

TEST_CASE("an answer of which a part has gone out is ended before the next") {
  Conversation c(300);
  c.begin();
  c.hear(ask(1));
  std::string all;
  for (int i = 0; i < 40; i++) {
    c.percept("dist(front,120)");
    all += "dist(front,120);";
  }
  c.hear(ask(2));
  CHECK(c.percepts.read(c.sent(), 1) == all);
}

TEST_CASE("a frame of 255 bytes arrives whole in the least memory that promises it") {
  Conversation c(JAVINO_MEMORY);
  std::string payload(255, 'x');
  CHECK(c.hear(frame1(payload)) == JAVINO_ACTION);
  CHECK(c.text() == payload);
  // Later frames have to wait for the bytes of this one.
  std::string next = frame1("ledOn");
  c.receive(next.substr(0, 6));
  CHECK(c.poll() == JAVINO_NOTHING);
  CHECK(c.hear(next.substr(6)) == JAVINO_ACTION);
  c.begin();
  CHECK(c.hear(frame2(0x30, 0, item(std::string(253, '\xA5')))) == JAVINO_ACTION);
  CHECK(c.text() == std::string(253, '\xA5'));
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
