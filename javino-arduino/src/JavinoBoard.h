/**
 * @file A board of the Arduino family: the common part of Javino.h (for serial ports) and JavinoNetwork.h.
 */
#ifndef JAVINO_BOARD_CLASS_H
#define JAVINO_BOARD_CLASS_H

#include <Arduino.h>

#include "JavinoActions.h"
#include "JavinoArguments.h"
#include "javino_board.h"
#include "javino_rules.h"

#ifndef JAVINO_BYTES
#if defined(RAMEND) && RAMEND < 0x0900
/* 2 KiB of RAM: room for the longest frame received and, besides a request, for an answer of 255 bytes. */
#define JAVINO_BYTES 368
#else
#define JAVINO_BYTES 640
#endif
#endif

/** The library's version: 0.1.0 is 100, 1.2.3 is 10203. */
#define JAVINO_LIBRARY_VERSION 100

#ifndef JAVINO_NO_DECIMALS
/** A number and the count of its decimals to write, see decimals(). */
struct JavinoDecimals {
  double value;
  uint8_t digits;
};

/**
 * In a percept, a number with more or fewer than two decimals: `percept("gps", decimals(48.137154, 6))` is gps(48.137154).
 *
 * @param digits  decimals, 1 to 9; on AVR a number has some seven digits in all
 */
inline JavinoDecimals decimals(double value, uint8_t digits) {
  JavinoDecimals number = {value, digits};
  return number;
}
#endif

/** A text that is a string, see quoted(). */
struct JavinoQuoted {
  const char *text;
};

/** In a percept, a text that is written as a string even if it could be an atom: `percept("says", quoted(word))` is says("hi"). */
inline JavinoQuoted quoted(const char *text) {
  JavinoQuoted value = {text};
  return value;
}

class JavinoBoard;

/**
 * The counters of a board, see JavinoBoard::countInto(). The sketch may read, reset and show them:
 * `board.percept("line", counters.frames, counters.damaged, counters.overruns, counters.longestLoop)`.
 */
class JavinoCounters {
public:
  unsigned long frames;  /**< Intact frames that have arrived. */
  unsigned long damaged; /**< Frames of version 2 that were not intact, and were dropped. Version 1 has no checksums. */
  /** How often the port's receive buffer was found full, so that bytes may have been lost. 0 where its size is not known. */
  unsigned long overruns;
  unsigned long longestLoop; /**< The most milliseconds from one look for messages to the next: a round of loop(), or a callback. */

  JavinoCounters() : frames(0), damaged(0), overruns(0), longestLoop(0) {}

private:
  friend class JavinoBoard;
  void (*hook_)(JavinoBoard &); /* The board's hook, which is called after counting. */
  unsigned long look_ms_;                    /* The time of the board's last look for messages. */
  uint8_t frames_;                           /* The counts of the core. */
  uint8_t damaged_;
};

/** An action whose outcome is reported later, see JavinoBoard::later(). */
typedef javino_later JavinoLater;

/**
 * A board on a line. Use Javino or JavinoNetwork, or JavinoSized or JavinoNetworkSized for another amount of memory.
 *
 * No function is called from an interrupt, and only a write to a line whose buffer is full waits; bytes that arrive meanwhile are kept.
 */
class JavinoBoard {
public:
  /** Called to write percepts, or when the link is lost. */
  typedef void (*Callback)();

  /**
   * Like Callback, but handed the board, whatever its class. So one function can serve several boards, and a class derived from a board
   * finds its members with `static_cast<Robot &>(board)`.
   */
  typedef JavinoActions::BoardFunction BoardCallback;

  /**
   * Sets the longest pause within a message, after which the message is given up.
   *
   * @param ms  milliseconds, at most 10,000; at a serial port 100 or, below 2000 baud, 20 byte times
   */
  void setTimeLimit(uint16_t ms) { javino_link_timeout(&board_.link, ms); }

  /** Takes the bytes that have arrived. run() and availableMsg() do so too, so a sketch without serialEvent() works. */
  void readSerial() { receive(); }

  /** @name Callbacks */
  ///@{

  /**
   * Handles all messages that have arrived: answers requests for percepts, carries out actions, reports a lost link. An action that the
   * board does not know is refused or, in version 1, ignored. Call it in every loop().
   *
   * Within a callback it only takes the bytes that have arrived, so that none is lost in a callback that takes long; requests and actions,
   * even `stop`, wait until the callback has returned. See later().
   */
  void run();

  /** Registers the function that writes percepts whenever they are asked for. It calls percept() or addPercept(). */
  void perceive(Callback write) {
    perceive_ = write;
    look_ = write ? perceiveAlone : NULL;
  }
  /** The same for a function that is handed the board. It is a template so that NULL counts as a Callback. */
  template <typename = void> void perceive(BoardCallback write) {
    perceive_ = reinterpret_cast<Callback>(write);
    look_ = write ? perceiveWithBoard : NULL;
  }

  /** `act["ledOn"] = ledOn;` has the function called for the action of exactly this text. */
  JavinoActions act;

  /**
   * Registers the function for an action with arguments.
   *
   * @param name       the functor, which is not copied; only one in flash is copied into the board's memory, so give it before anything has
   *                   arrived
   * @param function   takes the board, the arguments, both in this order, or neither; one that takes no arguments refuses an action that
   *                   has some. It returns `void`; or `bool`, where false refuses the action because of its arguments or for another reason
   * @param arguments  the number of arguments: with another number the action is refused and the function not called
   * @return false if it is left out: see JavinoActions::full()
   */
  bool onAction(const char *name, void (*function)(const JavinoArguments &), uint8_t arguments = JavinoActions::ANY) {
    return act.addWithArguments(name, reinterpret_cast<Callback>(function), JavinoActions::callWithArguments<void>, arguments);
  }
  bool onAction(const char *name, bool (*function)(const JavinoArguments &), uint8_t arguments = JavinoActions::ANY) {
    return act.addWithArguments(name, reinterpret_cast<Callback>(function), JavinoActions::callWithArguments<bool>, arguments);
  }
  bool onAction(const char *name, void (*function)(JavinoBoard &, const JavinoArguments &), uint8_t arguments = JavinoActions::ANY) {
    return act.addWithArguments(name, reinterpret_cast<Callback>(function), JavinoActions::callWithBoth<void>, arguments);
  }
  bool onAction(const char *name, bool (*function)(JavinoBoard &, const JavinoArguments &), uint8_t arguments = JavinoActions::ANY) {
    return act.addWithArguments(name, reinterpret_cast<Callback>(function), JavinoActions::callWithBoth<bool>, arguments);
  }
  bool onAction(const char *name, Callback function) { return function && act.add(name, function); }
  bool onAction(const char *name, bool (*function)()) {
    return act.addCalled(name, reinterpret_cast<Callback>(function), JavinoActions::callAlone<bool>);
  }
  bool onAction(const char *name, BoardCallback function) {
    return act.addCalled(name, reinterpret_cast<Callback>(function), JavinoActions::callWithBoard<void>);
  }
  bool onAction(const char *name, bool (*function)(JavinoBoard &)) {
    return act.addCalled(name, reinterpret_cast<Callback>(function), JavinoActions::callWithBoard<bool>);
  }
  /** Explains, at compile time, what to write for any other function. */
  template <typename Result, typename... Given> bool onAction(const char *, Result (*function)(Given...), uint8_t = JavinoActions::ANY) {
    return JavinoActions::explain(function);
  }

  template <typename Kind, typename... Arguments> bool onAction(const __FlashStringHelper *name, Kind function, Arguments... arguments) {
    const char *kept = act.keep(name);
    return kept && onAction(kept, function, arguments...);
  }

  /**
   * Registers the function for each action that the board does not know, or that has another number of arguments than its function takes.
   * Without it such an action is refused, and `argo.act` fails with `error(act_refused)`; in version 1, which has no outcomes, nothing
   * happens.
   *
   * While it is set the board does not describe its actions to computers, since ARGO sends a board only the actions that it has described.
   * So every action comes as text, and reaches the function.
   *
   * @param function  is handed the action's whole text, such as `fly(3)`, good until it returns. If it returns `void`, it may count or show
   *                  the action, which is then refused; if `bool`, true says that it has carried the action out. NULL: none
   */
  void onUnknownAction(void (*function)(JavinoBoard &board, const char *action)) { act.refuseWith(function); }
  /** The same for a function that returns bool. It is a template so that NULL counts as a function that returns void. */
  template <typename = void> void onUnknownAction(bool (*function)(JavinoBoard &board, const char *action)) { act.refuseWith(function); }

  /**
   * Call it in an action's function to report the outcome later, with done(). The function returns at once, its result is ignored, and the
   * board goes on: it answers requests while a gripper closes. ARGO's `argo.act` waits for the outcome. Until then no other action of
   * version 2 is carried out, not even an urgent one; if an action must be stoppable on the way, report it as carried out when it begins,
   * and its end with a percept.
   *
   * @return the value for done(). In version 1, which has no outcomes, a value with which done() does nothing
   */
  JavinoLater later() { return javino_link_later(&board_.link); }

  /**
   * Reports the outcome of an action that called later().
   *
   * @param carried_out  false if it could not be carried out
   * @return true if it was reported; false if the computer has begun anew since: then nobody waits for this outcome
   */
  bool done(JavinoLater later, bool carried_out = true) { return javino_link_done(&board_.link, later, carried_out); }

  /**
   * Registers the function that is called if nothing valid has arrived for this time, so that motors stop if the computer has died. Called
   * once, and again only after something has arrived. Bytes that arrived while loop() was busy count as having come at the beginning of
   * that time. Only a watchdog notices a loop() that never returns.
   *
   * @param ms  milliseconds; 0: never
   */
  void onLinkLost(unsigned long ms, Callback function) {
    silence_ms_ = ms;
    lost_ = function;
    supervise_ = ms && function ? loseAlone : NULL;
    javino_link_supervise(&board_.link, millis());
  }
  /** The same for a function that is handed the board. It is a template so that NULL counts as a Callback. */
  template <typename = void> void onLinkLost(unsigned long ms, BoardCallback function) {
    onLinkLost(ms, reinterpret_cast<Callback>(function));
    supervise_ = ms && function ? loseWithBoard : NULL;
  }

  /**
   * Counts incoming frames and the time of loop() into this from now on. A sketch that does not call it does not link the code.
   *
   * @param counters  lasts as long as the board
   */
  void countInto(JavinoCounters &counters) {
    counters.frames_ = board_.link.frames;
    counters.damaged_ = board_.link.decoder.damaged;
    counters.look_ms_ = millis();
    if (hook_ != count)
      counters.hook_ = hook_;
    else
      counters.hook_ = counters_->hook_;
    counters_ = &counters;
    hook_ = count;
  }

  /**
   * Lets the board watch critical rules itself, which the computer sets: a reflex is carried out within a run(), at once when a rule begins
   * to be met. The function given to perceive() is called up to every 5 ms for the percepts that the rules name. It should read no other
   * sensor; wants() tells which. Actions that are a reflex are called within percept().
   *
   * Call it in setup(), before anything arrives. A sketch that does not call it does not link the code.
   *
   * @param bytes  the part of the board's memory for the rules; one rule takes some 20 bytes
   * @return false if there is too little memory, something has arrived, or version 2 is left out
   */
  bool watchRules(uint8_t bytes = 96) {
#ifdef JAVINO_VERSION_1_ONLY
    (void)bytes;
    return false;
#else
    (hook_ && hook_ != rules ? counters_->hook_ : hook_) = rules;
    free_ = stream_.availableForWrite();
    return javino_rules_init(&board_, bytes, react, isFree);
#endif
  }
  ///@}

  /** @name Percepts */
  ///@{

  /**
   * Writes one percept of the answer: `percept("dist", "front", 30)` is dist(front,30).
   *
   * @param functor  an atom, with a ~ before it if the percept is negated
   * @param terms    whole numbers, of 64 bits too; numbers with decimals, of which two are written, or as many as decimals() has; true
   *                 and false; text, which becomes an atom if it is one and otherwise a string
   * @return false if it will not be sent: it is longer than a frame, or the memory is full and nobody has asked
   */
  template <typename... Terms> bool percept(const char *functor, Terms... terms) {
    return javino_percept_begin(&board_, functor) ? write(terms...) : true;
  }
  template <typename... Terms> bool percept(const __FlashStringHelper *functor, Terms... terms) {
    return begins(functor) ? write(terms...) : true;
  }

  /** Writes one percept given as text, without the `;` after it. @return as percept() */
  bool addPercept(const char *text);
  bool addPercept(const String &text) { return addPercept(text.c_str()); }
  bool addPercept(const __FlashStringHelper *text);

  /**
   * Describes a kind of percepts: `describe(F("dist(front|left, cm 0..400)"))`. Call it in the function given to perceive(), for each kind.
   * It writes only when a computer of version 2 asks for the description, which is seldom; wants() is false for all percepts then.
   *
   * @param kind  a functor, and for each argument `_` for anything, a choice such as `front|left` or `0|1`, or a number: its unit, if it
   *              has one, and its range, `cm 0..400`, `-40..125`, `% ..`; at most 250 bytes
   * @return as percept()
   */
  bool describe(const __FlashStringHelper *kind);

  /** Returns true if the request in hand asks for percepts of this functor; if not, the sensor need not be read. */
  bool wants(const char *functor) const { return javino_board_wants(&board_, functor, static_cast<uint8_t>(strlen(functor))); }
  bool wants(const __FlashStringHelper *functor) const;

  /** Sends the percepts as the answer. run() does so by itself after perceive()'s function. */
  void sendPercepts() { javino_board_answer(&board_); }

  /** Forgets the percepts that have been written. */
  void clearPercepts() { javino_board_clear(&board_); }
  ///@}

  /** @name Messages one by one, in place of run() */
  ///@{

  /** Looks for the next message. The message before is over: an action counts as carried out. Within a callback, see run(). */
  bool availableMsg();

  /** The message's text: an action, or getPercepts for a request. Empty if there is none. Uses the heap. */
  String getMsg() const;

  /** Returns true if the message asks for percepts. */
  bool requestPercepts() const { return board_.link.event == JAVINO_REQUEST; }

  /** Returns true if the message is the action of this text. */
  bool requestAction(const char *text) const;
  bool requestAction(const String &text) const { return requestAction(text.c_str()); }
  bool requestAction(const __FlashStringHelper *text) const;

  /** Refuses the message: the action is unknown or malformed. */
  void refuse() { javino_link_finish(&board_.link, false); }

  /**
   * Sends a message, at once or as an answer: percepts, each with a `;` after it. It goes out unchanged, whatever functors the request
   * names.
   *
   * @return false if a percept in it is longer than version 1 can send
   */
  bool sendMsg(const char *text) { return javino_board_send(&board_, text, strlen(text)); }
  bool sendMsg(const String &text) { return javino_board_send(&board_, text.c_str(), text.length()); }
  bool sendMsg(const __FlashStringHelper *text);
  ///@}

  /** @name As earlier libraries spelt them */
  ///@{
  bool availablemsg() { return availableMsg(); }
  String getmsg() const { return getMsg(); }
  bool sendmsg(const String &text) { return sendMsg(text); }
  ///@}

protected:
  /** Opens a port at this rate. */
  typedef void (*Open)(Stream &port, unsigned long baud);

  /* Only for the compiler, which wants a copy constructor in `Javino javino = Javino();` and then copies nothing. */
  JavinoBoard(const JavinoBoard &);

  /** A board on this stream. The memory is aligned for pointers. */
  JavinoBoard(Stream &stream, Open open, void *memory, uint16_t size);

  /** Forgets the part of a message that has arrived, since the rest does not come. */
  void forgetPart() {
    javino_decoder *decoder = &board_.link.decoder;
    uint8_t session = decoder->session;
    javino_decoder_init(decoder, decoder->bytes, decoder->size, decoder->timeout_ms);
    decoder->session = session;
  }

  Stream &stream_;
  Open open_; /* set by a subclass that opens its stream */

private:
  JavinoBoard &operator=(const JavinoBoard &);

  /** A hook for code that most sketches do not link. Called before messages are looked for. */
  typedef void (*Hook)(JavinoBoard &board);

  static void write(void *board, uint8_t byte);
  static void loseAlone(JavinoBoard &board);
  static void loseWithBoard(JavinoBoard &board);
  bool isLost() { return javino_link_lost(&board_.link, silence_ms_, millis()); }
  static void perceiveAlone(JavinoBoard &board);
  static void perceiveWithBoard(JavinoBoard &board);
  static void count(JavinoBoard &board);
  static void rules(JavinoBoard &board);
  static void look(void *board);
  static bool react(void *board, const char *text, uint8_t length);
  static bool isFree(void *board);

  /** Takes the bytes that have arrived. @return the time, by the core's clock */
  uint16_t receive();

  void next();
  void handle();
  bool carryOutAction();

  /** Does the same as javino_percept_begin. */
  bool begins(const __FlashStringHelper *functor);

  /** Writes a percept's terms and ends it. */
  template <typename... Terms> bool write(Terms... terms) {
    char before = '(';
    const bool each[] = {true, (javino_percept_put(&board_, before), before = ',', term(terms), true)...};
    (void)each;
    if (before == ',')
      javino_percept_put(&board_, ')');
    return javino_percept_end(&board_);
  }

  void term(bool value) { javino_percept_text(&board_, value ? "true" : "false"); }
  void term(char value);
  void term(signed char value) { term(static_cast<long>(value)); }
  void term(unsigned char value) { term(static_cast<unsigned long>(value)); }
  void term(short value) { term(static_cast<long>(value)); }
  void term(unsigned short value) { term(static_cast<unsigned long>(value)); }
  void term(int value) { term(static_cast<long>(value)); }
  void term(unsigned int value) { term(static_cast<unsigned long>(value)); }
  void term(long value) {
    javino_percept_number(&board_, value < 0 ? 0 - static_cast<uint32_t>(value) : static_cast<uint32_t>(value), value < 0);
  }
  void term(unsigned long value) { javino_percept_number(&board_, static_cast<uint32_t>(value), false); }
  void term(long long value) { longTerm(value < 0 ? 0 - static_cast<uint64_t>(value) : static_cast<uint64_t>(value), value < 0); }
  void term(unsigned long long value) { longTerm(value, false); }
  void longTerm(uint64_t magnitude, bool negative);
#ifdef JAVINO_NO_DECIMALS
  void term(double) = delete;
  void term(float) = delete;
#else
  void term(const JavinoDecimals &number);
  void term(double value);
  void term(float value) { term(static_cast<double>(value)); }
#endif
  void term(const char *value) { javino_percept_term(&board_, value); }
  void term(const JavinoQuoted &value) { javino_percept_string(&board_, value.text); }
  void term(char *value) { javino_percept_term(&board_, value); }
  void term(const __FlashStringHelper *value);
  /* Deleted, since any other pointer would count as a truth value. */
  template <typename Other> void term(Other *) = delete;
  void term(const String &value) { javino_percept_term(&board_, value.c_str()); }

  void (*look_)(JavinoBoard &); /* Calls perceive_. */
  Callback perceive_;            /* Set together with look_. */
  void (*supervise_)(JavinoBoard &); /* Null in a sketch that does not supervise its link, and so does not link the code. */
  Callback lost_;                    /* Set together with supervise_ and silence_ms_. */
  unsigned long silence_ms_;
  Hook hook_;
  JavinoCounters *counters_; /* Set together with the hook count. */
  int free_;                                  /* The port's room for bytes when all earlier ones have left. */
  bool waiting_; /* The action in hand waits for the bytes that follow it. */
  bool busy_;    /* run() or availableMsg() is under way. */
  bool mute_;    /* The port takes nothing more of this message. */
  javino_board board_;
};

#endif
