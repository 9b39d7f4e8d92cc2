#ifdef ARDUINO /* on other systems, only the core in C is used */

#include "JavinoBoard.h"

#include "javino_literal.h"

/** The most messages for one run(). A flood of messages then cannot block the rest of loop(). */
static const uint8_t MESSAGES_PER_RUN = 8;

JavinoBoard::JavinoBoard(Stream &stream, Open open, void *memory, uint16_t size)
    : act(&board_), stream_(stream), open_(open), look_(NULL), supervise_(NULL), hook_(NULL), waiting_(false), busy_(false),
      mute_(false) {
  javino_board_init(&board_, memory, size, write, this);
  act.begin();
}

uint16_t JavinoBoard::receive() {
  uint16_t now = static_cast<uint16_t>(millis());
  int byte;
  while (javino_link_ready(&board_.link) && (byte = stream_.read()) >= 0)
    javino_link_receive(&board_.link, static_cast<uint8_t>(byte), now);
  return now;
}

void JavinoBoard::write(void *board, uint8_t byte) {
  JavinoBoard *self = static_cast<JavinoBoard *>(board);
  /* Stops at the first byte that the port does not take. A USB port would wait for each further byte. */
  if (!self->mute_)
    self->mute_ = self->stream_.write(byte) == 0;
  /* The write may have waited, and the port's receive buffer is short. */
  self->receive();
}

void JavinoBoard::loseAlone(JavinoBoard &board) {
  if (board.isLost())
    board.lost_();
}

void JavinoBoard::loseWithBoard(JavinoBoard &board) {
  if (board.isLost())
    reinterpret_cast<BoardCallback>(board.lost_)(board);
}

void JavinoBoard::perceiveAlone(JavinoBoard &board) {
  board.perceive_();
}

void JavinoBoard::perceiveWithBoard(JavinoBoard &board) {
  reinterpret_cast<BoardCallback>(board.perceive_)(board);
}

void JavinoBoard::count(JavinoBoard &board) {
  const javino_link &link = board.board_.link;
  JavinoCounters &counters = *board.counters_;
  counters.frames += static_cast<uint8_t>(link.frames - counters.frames_);
  counters.frames_ = link.frames;
  counters.damaged += static_cast<uint8_t>(link.decoder.damaged - counters.damaged_);
  counters.damaged_ = link.decoder.damaged;
#ifdef SERIAL_RX_BUFFER_SIZE
  counters.overruns += board.stream_.available() == SERIAL_RX_BUFFER_SIZE - 1;
#endif
  unsigned long now = millis();
  if (now - counters.look_ms_ > counters.longestLoop)
    counters.longestLoop = now - counters.look_ms_;
  counters.look_ms_ = now;
  if (counters.hook_)
    counters.hook_(board);
}

#ifndef JAVINO_VERSION_1_ONLY
void JavinoBoard::rules(JavinoBoard &board) {
  javino_rules_look(&board.board_, look, board.receive());
}

JAVINO_NOINLINE void JavinoBoard::look(void *board) {
  JavinoBoard &self = *static_cast<JavinoBoard *>(board);
  if (self.look_)
    self.look_(self);
}

bool JavinoBoard::react(void *board, const char *text, uint8_t length) {
  return static_cast<JavinoBoard *>(board)->act.carryOut(text, length, true) == JavinoActions::DONE;
}

bool JavinoBoard::isFree(void *board) {
  JavinoBoard *self = static_cast<JavinoBoard *>(board);
  return self->stream_.availableForWrite() >= self->free_;
}
#endif

void JavinoBoard::next() {
  mute_ = false;
  if (hook_)
    hook_(*this);
  javino_board_poll(&board_, receive());
  if (supervise_)
    supervise_(*this);
}

bool JavinoBoard::availableMsg() {
  if (busy_) {
    receive();
    return false;
  }
  waiting_ = false;
  busy_ = true;
  next();
  busy_ = false;
  return board_.link.event != JAVINO_NOTHING;
}

void JavinoBoard::run() {
  if (busy_) {
    receive();
    return;
  }
  busy_ = true;
  handle();
  busy_ = false;
}

void JavinoBoard::handle() {
  for (uint8_t i = 0; i < MESSAGES_PER_RUN; i++) {
    if (!waiting_) {
      next();
      if (board_.link.event == JAVINO_NOTHING)
        return;
    }
    if (board_.link.event == JAVINO_REQUEST) {
      if (look_)
        look_(*this);
      sendPercepts();
    } else if (!carryOutAction()) {
      return;
    }
  }
}

/**
 * Carries out the present action. Returns false if the action must wait. In version 1 a damaged length may have truncated the text. A
 * truncated text seldom names an action, because its brackets are open. If the text names an action, the following bytes decide.
 */
bool JavinoBoard::carryOutAction() {
  const javino_link &link = board_.link;
  javino_follows follows = JAVINO_FOLLOWS_HEADER;
  if (!JAVINO_IS_2(&link))
    follows = javino_decoder_follows(&board_.link.decoder, receive());
  JavinoActions::Outcome outcome = act.carryOut(link.text, link.length, follows == JAVINO_FOLLOWS_HEADER);
  waiting_ = outcome == JavinoActions::UNCERTAIN && follows == JAVINO_FOLLOWS_UNKNOWN;
  if (waiting_)
    return false;
  if (outcome != JavinoActions::DONE)
    refuse();
  return true;
}

String JavinoBoard::getMsg() const {
  String text;
  if (board_.link.event == JAVINO_REQUEST)
    return String(F("getPercepts"));
  if (board_.link.event == JAVINO_ACTION) {
    text.reserve(board_.link.length);
    for (uint8_t i = 0; i < board_.link.length; i++)
      text += board_.link.text[i];
  }
  return text;
}

bool JavinoBoard::requestAction(const char *text) const {
  return board_.link.event == JAVINO_ACTION && strlen(text) == board_.link.length &&
         memcmp(text, board_.link.text, board_.link.length) == 0;
}

bool JavinoBoard::addPercept(const char *text) {
  const char *functor = *text == '~' ? text + 1 : text; /* Requests name functors without the ~. */
  if (!javino_board_wants(&board_, functor, javino_word(functor, JAVINO_MAX_PAYLOAD)))
    return true;
  javino_percept_text(&board_, text);
  return javino_percept_end(&board_);
}

bool JavinoBoard::addPercept(const __FlashStringHelper *text) {
  JAVINO_COPY(copy, text);
  return addPercept(copy);
}

bool JavinoBoard::describe(const __FlashStringHelper *kind) {
  if (!javino_kind_begin(&board_))
    return true;
  JAVINO_COPY(copy, kind);
  javino_percept_text(&board_, copy);
  return javino_percept_end(&board_);
}

bool JavinoBoard::begins(const __FlashStringHelper *functor) {
  JAVINO_COPY(copy, functor);
  return javino_percept_begin(&board_, copy);
}

bool JavinoBoard::wants(const __FlashStringHelper *functor) const {
  JAVINO_COPY(copy, functor);
  return wants(copy);
}

bool JavinoBoard::requestAction(const __FlashStringHelper *text) const {
  JAVINO_COPY(copy, text);
  return requestAction(copy);
}

bool JavinoBoard::sendMsg(const __FlashStringHelper *text) {
  JAVINO_COPY(copy, text);
  return sendMsg(copy);
}

void JavinoBoard::term(const __FlashStringHelper *value) {
  JAVINO_COPY(copy, value);
  term(copy);
}

void JavinoBoard::term(char value) {
  char text[] = {value, 0};
  term(text);
}

/** Writes a number with at least `least` digits, with leading zeros. */
static void putDigits(javino_board *board, uint64_t number, uint8_t least) {
  char digits[20];
  uint8_t n = 0;
  for (; number || n < least; number /= 10)
    digits[n++] = static_cast<char>('0' + number % 10);
  while (n)
    javino_percept_put(board, digits[--n]);
}

void JavinoBoard::longTerm(uint64_t magnitude, bool negative) {
  if (negative)
    javino_percept_put(&board_, '-');
  putDigits(&board_, magnitude, 1);
}

#ifndef JAVINO_NO_DECIMALS
void JavinoBoard::term(const JavinoDecimals &number) {
  uint8_t digits = number.digits < 1 ? 1 : number.digits > 9 ? 9 : number.digits;
  uint32_t parts = 1; /* 10 to the power of digits */
  for (uint8_t i = 0; i < digits; i++)
    parts *= 10;
  bool negative = number.value < 0;
  double magnitude = negative ? -number.value : number.value;
  if (!(magnitude < 4294967040.0)) { /* not >=: NaN must take this branch too */
    term(number.value);
    return;
  }
  uint32_t whole = static_cast<uint32_t>(magnitude);
  uint32_t decimals = static_cast<uint32_t>((magnitude - whole) * parts + 0.5);
  if (decimals >= parts) {
    whole++;
    decimals -= parts;
  }
  javino_percept_number(&board_, whole, negative && (whole || decimals));
  javino_percept_put(&board_, '.');
  putDigits(&board_, decimals, digits);
}

void JavinoBoard::term(double value) {
  if (value != value) {
    term("nan");
    return;
  }
  bool negative = value < 0;
  double rounded = (negative ? -value : value) + 0.005;
  if (rounded >= 4294967040.0) {
    term(negative ? "negative_infinity" : "infinity");
    return;
  }
  uint32_t whole = static_cast<uint32_t>(rounded);
  uint8_t hundredths = static_cast<uint8_t>((rounded - whole) * 100);
  javino_percept_number(&board_, whole, negative && (whole || hundredths));
  javino_percept_put(&board_, '.');
  javino_percept_put(&board_, static_cast<char>('0' + hundredths / 10));
  javino_percept_put(&board_, static_cast<char>('0' + hundredths % 10));
}
#endif

#endif
