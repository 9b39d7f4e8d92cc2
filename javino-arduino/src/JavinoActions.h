#ifndef JAVINO_ACTIONS_H
#define JAVINO_ACTIONS_H

#include <Arduino.h>
#include <string.h>

#include "JavinoArguments.h"
#include "javino_board.h"

class JavinoBoard;

/**
 * The actions that a board knows, by name. Actions lie in the board's memory, seven bytes each on AVR. Only a name that is a String takes
 * heap. A name in flash, F("ledOn"), is copied into the board's memory, so register it before anything arrives. Other names are not copied,
 * so they must last.
 */
class JavinoActions {
public:
  /** An action without arguments. */
  typedef void (*Function)();

  /** An action without arguments that gets the board. */
  typedef void (*BoardFunction)(JavinoBoard &board);

  /** Any number of arguments. */
  static const uint8_t ANY = JAVINO_ANY;

  /** The result of `act["ledOn"]`: a place for one action. The name is a text, a String, or a text in flash. */
  template <typename Name> class Place {
  public:
    Place(JavinoActions &actions, Name name) : actions_(actions), name_(name) {}

    /** Registers the function for the action with exactly this name. */
    void operator=(Function function) {
      const char *name = function ? actions_.keep(name_) : NULL;
      if (name)
        actions_.add(name, function);
    }

    /** The same for a function that gets the board. It is a template so that NULL counts as a Function. */
    template <typename = void> void operator=(BoardFunction function) {
      const char *name = function ? actions_.keep(name_) : NULL;
      if (name)
        actions_.addCalled(name, reinterpret_cast<Function>(function), callWithBoard<void>);
    }

    /** Says in a compile error what to write for any other function. */
    template <typename Result, typename... Given> void operator=(Result (*function)(Given...)) { explain(function); }

    /** Carries the action out, if there is one of this name. */
    void operator()() const { actions_.carryOut(name_); }

  private:
    JavinoActions &actions_;
    Name name_;
  };

  explicit JavinoActions(javino_board *board) : board_(board), reader_(NULL), count_(0), described_(true) {}

  Place<const char *> operator[](const char *name) { return Place<const char *>(*this, name); }
  Place<const String &> operator[](const String &name) { return Place<const String &>(*this, name); }
  Place<const __FlashStringHelper *> operator[](const __FlashStringHelper *name) {
    return Place<const __FlashStringHelper *>(*this, name);
  }

  /** The number of actions. */
  uint8_t count() const { return count_; }

  /**
   * Returns true if an action has been left out, because the memory was full (JavinoSized can have more), there were JAVINO_ACTIONS_MAX
   * actions, the name was longer than JAVINO_NAME_MAX, or percepts had been written before.
   */
  bool full() const { return board_->link.actions_lost != 0; }

private:
  friend class JavinoBoard;

  struct Action;

  /** Calls an action's function. Returns false if the function refuses the action. */
  typedef bool (*Caller)(Function function, JavinoBoard &board, const JavinoArguments &arguments);

  struct Action {
    javino_action named;
    Function function;
    Caller caller; /* null: the function takes neither the board nor arguments, and returns nothing */
  };

  enum Outcome : uint8_t {
    DONE,
    REFUSED,  /* the action's function has refused it */
    UNKNOWN,  /* there is no such action, or it takes another number of arguments */
    UNCERTAIN /* the text may be cut, and another action begins with it */
  };

  /** A call of this function does not compile; the error message says what to write. */
  template <typename Other> static bool explain(Other function) {
    static_assert(sizeof(function) == 0,
                  "the function does not fit. act[\"name\"] = function takes void function() or void function(JavinoBoard &). "
                  "onAction(\"name\", function) takes void or bool function(const JavinoArguments &arguments), for an action with "
                  "arguments, and bool function(), which refuses the action by returning false");
    return false;
  }

  JavinoActions(const JavinoActions &);
  JavinoActions &operator=(const JavinoActions &);

  JAVINO_NOINLINE bool add(const char *name, Function function, Caller caller = NULL, uint8_t arguments = 0);
  void leaveOut();

  /** Returns the name as a text that lasts: a String's on the heap, a name in flash in the board's memory. Null: the action is left out. */
  static const char *keep(const char *name) { return name; }
  const char *keep(const String &name);
  const char *keep(const __FlashStringHelper *name);

  bool addCalled(const char *name, Function function, Caller caller) {
    if (!function)
      return false;
    Reader &place = reader();
    if (!place)
      place = callFound;
    return add(name, function, caller);
  }
  bool addWithArguments(const char *name, Function function, Caller caller, uint8_t arguments) {
    if (!function)
      return false;
    reader() = callByFunctor; /* also finds an action by its functor */
    return add(name, function, caller, arguments);
  }
  Outcome carryOut(const char *text, uint8_t length, bool certain) const;
  void carryOut(const char *name) const { carryOut(name, static_cast<uint8_t>(strlen(name)), true); }
  void carryOut(const String &name) const { carryOut(name.c_str()); }
  void carryOut(const __FlashStringHelper *name) const;

  /**
   * Carries out an action. Null while no function takes the board or arguments. `found` is the action whose name is the whole text, or
   * null. `certain` is true if the text is known to be whole.
   */
  typedef Outcome (*Reader)(const JavinoActions &actions, const Action *found, const char *text, uint8_t length, bool certain);

  /** The reader of actions that are known. */
  Reader &reader() { return described_ ? reader_ : known_; }

  static Outcome callFound(const JavinoActions &actions, const Action *found, const char *text, uint8_t length, bool certain);
  static Outcome callByFunctor(const JavinoActions &actions, const Action *found, const char *text, uint8_t length, bool certain);
  static Outcome call(const JavinoActions &actions, const Action &action, const JavinoArguments &arguments);

  JavinoBoard &board() const { return *static_cast<JavinoBoard *>(board_->link.encoder.context); }

  /** @name Callers of functions. A function returns bool, or void if it never refuses. */
  ///@{
  template <typename... Given> static bool isDone(bool (*function)(Given...), Given... given) { return function(given...); }
  template <typename... Given> static bool isDone(void (*function)(Given...), Given... given) {
    function(given...);
    return true;
  }
  template <typename Result> static bool callAlone(Function function, JavinoBoard &, const JavinoArguments &) {
    return isDone(reinterpret_cast<Result (*)()>(function));
  }
  template <typename Result> static bool callWithBoard(Function function, JavinoBoard &board, const JavinoArguments &) {
    return isDone<JavinoBoard &>(reinterpret_cast<Result (*)(JavinoBoard &)>(function), board);
  }
  template <typename Result> static bool callWithArguments(Function function, JavinoBoard &, const JavinoArguments &arguments) {
    return isDone<const JavinoArguments &>(reinterpret_cast<Result (*)(const JavinoArguments &)>(function), arguments);
  }
  template <typename Result> static bool callWithBoth(Function function, JavinoBoard &board, const JavinoArguments &arguments) {
    return isDone<JavinoBoard &, const JavinoArguments &>(
        reinterpret_cast<Result (*)(JavinoBoard &, const JavinoArguments &)>(function), board, arguments);
  }
  ///@}

  /** Registers the function for unknown actions; null: none. */
  template <typename Result> void refuseWith(Result (*function)(JavinoBoard &, const char *)) {
    if (described_)
      known_ = reader_;
    unknown_ = reinterpret_cast<Function>(function);
    described_ = !function;
    reader_ = function ? askUnknown<Result> : known_;
    board_->link.action_count = function ? 0 : count_;
  }
  template <typename Result>
  static Outcome askUnknown(const JavinoActions &actions, const Action *found, const char *text, uint8_t length, bool certain) {
    Outcome outcome = (actions.known_ ? actions.known_ : callFound)(actions, found, text, length, certain);
    if (outcome != UNKNOWN)
      return outcome;
    if (!certain)
      return UNCERTAIN;
    char action[JAVINO_MAX_PAYLOAD + 1];
    memcpy(action, text, length);
    action[length] = 0;
    return ask(reinterpret_cast<Result (*)(JavinoBoard &, const char *)>(actions.unknown_), actions.board(), action);
  }
  static Outcome ask(bool (*function)(JavinoBoard &, const char *), JavinoBoard &board, const char *action) {
    return function(board, action) ? DONE : REFUSED;
  }
  static Outcome ask(void (*function)(JavinoBoard &, const char *), JavinoBoard &board, const char *action) {
    function(board, action);
    return REFUSED;
  }

  /** Tells the link the distance between two actions in memory. */
  void begin() { board_->link.action_size = sizeof(Action); }

  /** The newest action; older ones lie behind it. */
  const Action *newest() const { return static_cast<const Action *>(board_->link.actions); }

  javino_board *board_;
  /* Null until an action needs a reader: other sketches do not link that code. */
  Reader reader_;
  Reader known_;     /* The reader of known actions while unknown_ is set; else it is in reader_. */
  Function unknown_; /* The function for unknown actions. */
  uint8_t count_;
  bool described_; /* True: the board describes its actions to computers. */
};

#endif
