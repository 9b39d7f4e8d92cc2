/** @file A board with a far end that writes whole frames and keeps what comes back. */
#ifndef CONVERSATION_H
#define CONVERSATION_H

#include <doctest/doctest.h>

#include <cstring>
#include <string>
#include <vector>

#include "frames.h"
#include "javino_board.h"

struct Conversation {
  std::vector<uint8_t> memory;
  javino_board board;
  std::string out;
  std::string waiting; /* in the receive buffer */
  uint16_t now = 1000;
  Percepts percepts;
  std::vector<std::pair<std::string, uint8_t>> actions; /* with how many arguments */
  std::vector<javino_action> named;

  explicit Conversation(uint16_t bytes = JAVINO_MEMORY + 255) : memory(bytes) {
    REQUIRE(javino_board_init(&board, memory.data(), bytes, write, this));
    board.link.action_size = sizeof(javino_action);
    poll();
  }

  static void write(void *self, uint8_t byte) { static_cast<Conversation *>(self)->out += static_cast<char>(byte); }

  /** Receives bytes while the program polls often. */
  void receive(const std::string &bytes) {
    javino_decoder_idle(&board.link.decoder, now);
    find(bytes);
  }

  /** Receives bytes that have waited in the receive buffer until the program looks into it. */
  void find(const std::string &bytes) {
    waiting += bytes;
    size_t n = 0;
    for (; n < waiting.size() && javino_link_ready(&board.link); n++)
      javino_link_receive(&board.link, static_cast<uint8_t>(waiting[n]), now);
    waiting.erase(0, n);
  }

  /** Gives the link the board's present actions. */
  void name() {
    named.clear();
    for (auto action = actions.rbegin(); action != actions.rend(); ++action)
      named.push_back({action->first.c_str(), action->second});
    board.link.actions = named.data();
    board.link.action_count = static_cast<uint8_t>(named.size());
  }

  javino_event poll() {
    find("");
    name();
    return javino_board_poll(&board, now);
  }

  javino_event hear(const std::string &bytes) {
    receive(bytes);
    javino_event event = poll();
    while (event == JAVINO_NOTHING && !waiting.empty())
      event = poll();
    return event;
  }

  /** Begins a session and forgets the answer. */
  void begin(unsigned nonce = 7) {
    hear(hello(nonce));
    percepts = Percepts();
    sent();
  }

  void finish(bool done = true) { javino_link_finish(&board.link, done); }

  std::string text() const { return std::string(board.link.text, board.link.length); }

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

  /** Returns the text of the answer that the board sends now. */
  std::string answered(unsigned request) {
    javino_board_answer(&board);
    return percepts.read(sent(), request);
  }
};

/** Returns the payloads of version 1 frames that follow each other; the test fails if the bytes are anything else. */
inline std::vector<std::string> payloads1(const std::string &bytes) {
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

#endif
