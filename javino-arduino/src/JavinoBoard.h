/** @file A board of the Arduino family: the common part of Javino.h (for serial ports) and JavinoNetwork.h. */
#ifndef JAVINO_BOARD_CLASS_H
#define JAVINO_BOARD_CLASS_H

#include <Arduino.h>

#include "JavinoActions.h"
#include "JavinoArguments.h"
#include "javino_board.h"
#include "javino_rules.h"

#ifndef JAVINO_BYTES
#if defined(RAMEND) && RAMEND < 0x0900
/* 2 KiB of RAM: room for the longest frame, or for a request and an answer of 255 bytes. */
#define JAVINO_BYTES 368
#else
#define JAVINO_BYTES 640
#endif
#endif

/** The library's version: 0.1.0 is 100, 1.2.3 is 10203. */
#define JAVINO_LIBRARY_VERSION 100

#ifndef JAVINO_NO_DECIMALS
/** A number with a number of decimals, see decimals(). */
struct JavinoDecimals {
  double value;
  uint8_t digits;
};

/** A number in a percept with 1 to 9 decimals: `percept("gps", decimals(48.137154, 6))`. On AVR a number has about seven digits in all. */
inline JavinoDecimals decimals(double value, uint8_t digits) {
  JavinoDecimals number = {value, digits};
  return number;
}
#endif

/** A text that becomes a string, see quoted(). */
struct JavinoQuoted {
  const char *text;
};

/** A text in a percept that becomes a string even if it is an atom: `percept("says", quoted(word))` is says("hi"). */
inline JavinoQuoted quoted(const char *text) {
  JavinoQuoted value = {text};
  return value;
}

class JavinoBoard;

/**
 * The counters of a board, see JavinoBoard::countInto(). The sketch may read and reset them, and send them as percepts:
 * `board.percept("line", counters.frames, counters.damaged, counters.overruns, counters.longestLoop)`.
 */
class JavinoCounters {
public:
  unsigned long frames;  /**< Intact frames that have arrived. */
  unsigned long damaged; /**< Dropped damaged frames of version 2. Version 1 has no checksums. */
  /** How often the port's receive buffer was full. Bytes may have been lost then. Always 0 if the buffer's size is not known. */
  unsigned long overruns;
  unsigned long longestLoop; /**< The longest time in ms between two checks for messages: the longest loop() or callback. */

  JavinoCounters() : frames(0), damaged(0), overruns(0), longestLoop(0) {}

private:
  friend class JavinoBoard;
  void (*hook_)(JavinoBoard &); /* The board's previous hook, called after counting. */
  unsigned long look_ms_;                    /* Time of the last check for messages. */
  uint8_t frames_;                           /* The link's count of frames at the last check. damaged_: of damaged frames. */
  uint8_t damaged_;
};

/** An action whose outcome is reported later, see JavinoBoard::later(). */
typedef javino_later JavinoLater;

/**
 * A board on a line. Use Javino or JavinoNetwork. For another amount of memory use JavinoSized or JavinoNetworkSized. Registered
 * functions never run in an interrupt. Only a write to a line with a full buffer waits. Bytes that arrive during the wait are kept.
 */
class JavinoBoard {
public:
  /** Called to write percepts, or after the link is lost. */
  typedef void (*Callback)();

  /**
   * A Callback that gets the board. One function can then serve several boards. If the board has a derived class,
   * `static_cast<Robot &>(board)` gives access to the members of that class.
   */
  typedef JavinoActions::BoardFunction BoardCallback;

  /**
   * Sets the longest pause within a message, at most 10,000 ms. The default at a serial port is 100 ms. Below 2000 baud the default is 20
   * byte times.
   */
  void setTimeLimit(uint16_t ms) { javino_link_timeout(&board_.link, ms); }

  /** Takes the bytes that have arrived. run() and availableMsg() also do this, so a sketch needs no serialEvent(). */
  void readSerial() { receive(); }

  /** @name Callbacks */
  ///@{

  /**
   * Handles all messages that have arrived: answers requests for percepts, carries out actions, reports a lost link. Refuses unknown
   * actions in version 2, ignores them in version 1. Call run() in every loop(). Within a callback, run() only takes the bytes that have
   * arrived, so a long callback loses no bytes. Requests and actions, even `stop`, wait until the callback has returned. See later().
   */
  void run();

  /** Registers the function that writes percepts for each request. The function calls percept() or addPercept(). */
  void perceive(Callback write) {
    perceive_ = write;
    look_ = write ? perceiveAlone : NULL;
  }
  /** Registers a function that gets the board. This is a template, so NULL counts as a Callback. */
  template <typename = void> void perceive(BoardCallback write) {
    perceive_ = reinterpret_cast<Callback>(write);
    look_ = write ? perceiveWithBoard : NULL;
  }

  /** `act["ledOn"] = ledOn;` registers the function for the action with exactly this text. */
  JavinoActions act;

  /**
   * Registers the function for an action with arguments.
   *
   * @param name       the functor. The board does not copy the name, so the name must stay valid. A name in flash is copied into the
   *     board's memory, so register it before anything arrives
   * @param function   takes the board, the arguments, both in this order, or neither. A function without the arguments refuses an action
   *     with arguments. The function returns `void` or `bool`. false refuses the action
   * @param arguments  the number of arguments. An action with another number is refused without a call
   * @return false if the action is left out, see JavinoActions::full()
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
  /** Any other function: a compile error says what to write. */
  template <typename Result, typename... Given> bool onAction(const char *, Result (*function)(Given...), uint8_t = JavinoActions::ANY) {
    return JavinoActions::explain(function);
  }

  template <typename Kind, typename... Arguments> bool onAction(const __FlashStringHelper *name, Kind function, Arguments... arguments) {
    const char *kept = act.keep(name);
    return kept && onAction(kept, function, arguments...);
  }

  /**
   * Registers the function for unknown actions and for actions with a wrong number of arguments. Without such a function the board
   * refuses these actions, and `argo.act` fails with `error(act_refused)`. Version 1 has no outcomes, so in version 1 the board ignores
   * these actions.
   *
   * While a function is registered, the board does not describe its actions to computers. ARGO would send only described actions. Every
   * action then arrives as text.
   *
   * @param function  gets the action's whole text, such as `fly(3)`, which is valid until the function returns. A function that returns
   *     `void` refuses the action. A function that returns `bool` returns true if it has carried the action out. NULL: no function
   */
  void onUnknownAction(void (*function)(JavinoBoard &board, const char *action)) { act.refuseWith(function); }
  /** Registers a function that returns bool. This is a template, so NULL counts as a function that returns void. */
  template <typename = void> void onUnknownAction(bool (*function)(JavinoBoard &board, const char *action)) { act.refuseWith(function); }

  /**
   * Call later() in an action's function to report the outcome later, with done(). The function then returns at once, and its result is
   * ignored. Meanwhile the board answers requests, for example while a gripper closes. ARGO's `argo.act` waits for the outcome. Until
   * done() is called, the board carries out no other action of version 2, not even an urgent one. If another action must be able to stop
   * this action, do not call later(). Report the end of this action with a percept instead.
   *
   * @return the value for done(). Version 1 has no outcomes: done() then does nothing
   */
  JavinoLater later() { return javino_link_later(&board_.link); }

  /**
   * Reports whether an action with later() was carried out. @return false if nobody waits for the outcome, for example after a new
   * session
   */
  bool done(JavinoLater later, bool carried_out = true) { return javino_link_done(&board_.link, later, carried_out); }

  /**
   * Registers a function for a lost link. The board calls the function if nothing valid has arrived for `ms` milliseconds. With 0, the
   * board never calls the function. The function can stop motors if the computer fails. The board calls the function once, and again only
   * after something has arrived. Bytes that arrived during a long loop() count as arrived at its beginning (javino_link_lost). If loop()
   * never returns, only a watchdog helps.
   */
  void onLinkLost(unsigned long ms, Callback function) {
    silence_ms_ = ms;
    lost_ = function;
    supervise_ = ms && function ? loseAlone : NULL;
    javino_link_supervise(&board_.link, millis());
  }
  /** Registers a function that gets the board. This is a template, so NULL counts as a Callback. */
  template <typename = void> void onLinkLost(unsigned long ms, BoardCallback function) {
    onLinkLost(ms, reinterpret_cast<Callback>(function));
    supervise_ = ms && function ? loseWithBoard : NULL;
  }

  /**
   * Starts to count incoming frames and the time of loop(). The counters must stay valid. Sketches without this call do not link the
   * code.
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
   * Lets the board itself watch critical rules from the computer. When a rule begins to match, run() carries out its reflex at once. At
   * most every 5 ms, run() calls the function of perceive() for the percepts in the rules. This function should read only sensors for
   * which wants() returns true. percept() calls the action of a reflex.
   *
   * Call watchRules() in setup(), before anything arrives. A sketch without this call does not link the code.
   *
   * @param bytes  the part of the board's memory for the rules, in bytes. One rule takes about 20 bytes
   * @return false if there is too little memory, if something has arrived, or if version 2 is left out
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
   * @param functor  an atom, perhaps with a ~ in front
   * @param terms    whole numbers of up to 64 bits; numbers, with two decimals unless decimals() sets another number; true and false;
   *     text, which becomes an atom if possible, else a string
   * @return false if the percept is not sent: it is longer than a frame, or the memory is full and there is no request to answer
   */
  template <typename... Terms> bool percept(const char *functor, Terms... terms) {
    return javino_percept_begin(&board_, functor) ? write(terms...) : true;
  }
  template <typename... Terms> bool percept(const __FlashStringHelper *functor, Terms... terms) {
    return begins(functor) ? write(terms...) : true;
  }

  /** Writes one percept, given as text without the `;`. @return as percept() */
  bool addPercept(const char *text);
  bool addPercept(const String &text) { return addPercept(text.c_str()); }
  bool addPercept(const __FlashStringHelper *text);

  /**
   * Describes a kind of percepts: `describe(F("dist(front|left, cm 0..400)"))`. Call describe() for each kind, in the function of
   * perceive(). describe() writes only if a computer of version 2 has requested the description. During such a request wants() returns
   * false for all percepts.
   *
   * @param kind  a functor, and for each argument `_` (anything), a choice (`front|left`, `0|1`), or a number's unit, if any, and range
   *     (`cm 0..400`, `-40..125`, `% ..`); at most 250 bytes
   * @return as percept()
   */
  bool describe(const __FlashStringHelper *kind);

  /** Returns true if the present request asks for percepts with this functor. If not, the sensor need not be read. */
  bool wants(const char *functor) const { return javino_board_wants(&board_, functor, static_cast<uint8_t>(strlen(functor))); }
  bool wants(const __FlashStringHelper *functor) const;

  /** Sends the written percepts as the answer. run() does this after the function of perceive(). */
  void sendPercepts() { javino_board_answer(&board_); }

  /** Forgets the written percepts. */
  void clearPercepts() { javino_board_clear(&board_); }
  ///@}

  /** @name Messages one by one, in place of run() */
  ///@{

  /** Looks for the next message. The previous action then counts as carried out. Within a callback, only takes bytes and returns false. */
  bool availableMsg();

  /** Returns the message's text: an action, or getPercepts for a request. Empty if there is no message. Uses the heap. */
  String getMsg() const;

  /** Returns true if the message asks for percepts. */
  bool requestPercepts() const { return board_.link.event == JAVINO_REQUEST; }

  /** Returns true if the message is exactly this action. */
  bool requestAction(const char *text) const;
  bool requestAction(const String &text) const { return requestAction(text.c_str()); }
  bool requestAction(const __FlashStringHelper *text) const;

  /** Refuses the message as unknown or malformed. */
  void refuse() { javino_link_finish(&board_.link, false); }

  /**
   * Sends a message, unasked or as an answer: percepts, each followed by `;`. Sends all given percepts, even if the request names only
   * some functors.
   *
   * @return false if a percept is too long for version 1
   */
  bool sendMsg(const char *text) { return javino_board_send(&board_, text, strlen(text)); }
  bool sendMsg(const String &text) { return javino_board_send(&board_, text.c_str(), text.length()); }
  bool sendMsg(const __FlashStringHelper *text);
  ///@}

  /** @name Spellings of earlier libraries */
  ///@{
  bool availablemsg() { return availableMsg(); }
  String getmsg() const { return getMsg(); }
  bool sendmsg(const String &text) { return sendMsg(text); }
  ///@}

protected:
  /** Opens a port with this baud rate. */
  typedef void (*Open)(Stream &port, unsigned long baud);

  /* Never called, but `Javino javino = Javino();` needs a copy constructor. */
  JavinoBoard(const JavinoBoard &);

  /** A board on this stream. The memory is aligned for pointers. */
  JavinoBoard(Stream &stream, Open open, void *memory, uint16_t size);

  /** Forgets an incomplete message, because its rest will not arrive. */
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

  /** A hook for code that most sketches do not link. Called before each search for messages. */
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

  bool begins(const __FlashStringHelper *functor);

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
  /* Deleted, because any other pointer would convert to bool. */
  template <typename Other> void term(Other *) = delete;
  void term(const String &value) { javino_percept_term(&board_, value.c_str()); }

  void (*look_)(JavinoBoard &); /* Calls perceive_. */
  Callback perceive_;
  void (*supervise_)(JavinoBoard &); /* Null if the sketch does not supervise the link. The code for supervision is then not linked. */
  Callback lost_;
  unsigned long silence_ms_;
  Hook hook_;
  JavinoCounters *counters_;
  int free_;                                  /* The port's room for bytes when its buffer is empty. */
  bool waiting_; /* Whether the present action waits for the following bytes. */
  bool busy_;    /* Whether run() or availableMsg() is running. */
  bool mute_;    /* Whether the port has stopped to take bytes of this message. */
  javino_board board_;
};

#endif
