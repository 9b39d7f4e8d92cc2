// The rest of the core if a switch leaves a part out. Built once for each switch.

#include "conversation.h"

namespace {

/** Writes two percepts, as far as they are wanted. */
void look(Conversation &c) {
  for (const char *functor : {"light", "dist"})
    if (javino_percept_begin(&c.board, functor)) {
      javino_percept_text(&c.board, "(1)");
      javino_percept_end(&c.board);
    }
}

/** Returns the answer to a request in version 1. */
std::string answer1(Conversation &c, const std::string &request) {
  if (c.hear(frame1(request)) != JAVINO_REQUEST)
    return c.sent();
  look(c);
  javino_board_answer(&c.board);
  return c.sent();
}

#ifndef JAVINO_VERSION_1_ONLY
/** The same in version 2. */
std::string answer2(Conversation &c, unsigned number, const std::string &functors) {
  REQUIRE(c.hear(ask(number, 0, functors)) == JAVINO_REQUEST);
  look(c);
  return c.answered(number);
}
#endif

}  // namespace

#ifdef JAVINO_VERSION_1_ONLY

TEST_CASE("without version 2 a board answers in version 1 and hears no session") {
  Conversation c;
  c.hear(hello());
  CHECK(c.sent() == "");
  c.now += 200;
  CHECK(answer1(c, "getPercepts") == frame1("light(1);dist(1);"));
  CHECK(answer1(c, "getPercepts(dist)") == frame1("dist(1);"));
  CHECK(c.hear(frame1("go(1)")) == JAVINO_ACTION);
}

#elif defined(JAVINO_VERSION_2_ONLY)

TEST_CASE("without version 1 a board says nothing before a session, and then all that it says with one") {
  Conversation c;
  CHECK(answer1(c, "getPercepts") == "");
  CHECK(c.hear(frame1("go(1)")) == JAVINO_NOTHING);
  c.now += 200;
  c.percept("light(1)");
  javino_board_answer(&c.board);
  CHECK(!javino_board_send(&c.board, "light(1);", 9));
  CHECK(c.sent() == "");
  c.begin();
  c.sent();
  CHECK(answer2(c, 1, "") == "light(1);dist(1);");
  CHECK(answer2(c, 2, "(dist)") == "dist(1);");
  CHECK(javino_board_send(&c.board, "light(1);", 9));
  CHECK(frames2(c.sent()).size() == 1);
  CHECK(c.hear(command(0, "go(1)")) == JAVINO_ACTION);
  c.poll();
  CHECK(c.sent() == ack(1));
  // Nor behind a silence.
  c.now += 200;
  CHECK(answer1(c, "getPercepts") == "");
  CHECK(c.hear(ask(3)) == JAVINO_REQUEST);
}

TEST_CASE("without version 1 frames are found behind any bytes") {
  Conversation c;
  c.begin();
  c.sent();
  c.hear(std::string(300, 'f') + "fffe05go(1)" + std::string(3, '\0'));
  CHECK(c.hear(command(0, "go(1)")) == JAVINO_ACTION);
}

#else

TEST_CASE("without lists of functors a request is answered with all percepts") {
  Conversation c;
  CHECK(answer1(c, "getPercepts(dist)") == frame1("light(1);dist(1);"));
  c.begin();
  CHECK(answer2(c, 1, "(dist)") == "light(1);dist(1);");
}

#endif
