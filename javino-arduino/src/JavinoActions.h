#ifndef JAVINO_ACTIONS_H
#define JAVINO_ACTIONS_H

#include <Arduino.h>
#include <string.h>

#include "JavinoArguments.h"
#include "javino_board.h"

class JavinoBoard;

/**
 * The actions of a board, by name. Actions are stored in the board's memory, seven bytes each on AVR. Only a name that is a String uses
 * heap. A name in flash, F("ledOn"), is copied into the board's memory, so register it before anything arrives. Other names are not
 * copied, so they must stay valid.
 */
class JavinoActions {
public:
  /** An action without arguments. */
  typedef void (*Function)();

  /** An action without arguments whose function gets the board. */
  typedef void (*BoardFunction)(JavinoBoard &board);

  /** Stands for any number of arguments. */
  static const uint8_t ANY = JAVINO_ANY;

  /** The result of `act["ledOn"]`: a place for one action. The name is a C string, a String, or a text in flash. */
  template <typename Name> class Place {
  public:
    Place(JavinoActions &actions, Name name) : actions_(actions), name_(name) {}

    /** Registers the function for the action with exactly this name. */
    void operator=(Function function) {
      const char *name = function ? actions_.keep(name_) : NULL;
      if (name)
        actions_.add(name, function);
    }

    /** Registers a function that gets the board. This is a template, so NULL counts as a Function. */
    template <typename = void> void operator=(BoardFunction function) {
      const char *name = function ? actions_.keep(name_) : NULL;
      if (name)
        actions_.addCalled(name, reinterpret_cast<Function>(function), callWithBoard<void>);
    }

    /** Any other function: a compile error says what to write. */
    template <typename Result, typename... Given> void operator=(Result (*function)(Given...)) { explain(function); }

    /** Carries out the action with this name, if there is one. */
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
   * Returns true if an action was left out. Reasons: the memory was full (JavinoSized can have more), there were JAVINO_ACTIONS_MAX
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
    Caller caller; /* null for a void function without parameters */
  };

  enum Outcome : uint8_t {
    DONE,
    REFUSED,  /* the action's function has refused */
    UNKNOWN,  /* no action has this name and number of arguments */
    UNCERTAIN /* the text may be truncated, and another action begins with it */
  };

  /** Calling this is a compile error. The error's message says what to write. */
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

  /**
   * Returns the name as a text that stays valid: on the heap for a String, in the board's memory for a name in flash. Null: the action is
   * left out.
   */
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
    reader() = callByFunctor; /* also searches by functor */
    return add(name, function, caller, arguments);
  }
  Outcome carryOut(const char *text, uint8_t length, bool certain) const;
  void carryOut(const char *name) const { carryOut(name, static_cast<uint8_t>(strlen(name)), true); }
  void carryOut(const String &name) const { carryOut(name.c_str()); }
  void carryOut(const __FlashStringHelper *name) const;

  /**
   * Carries out an action. Null while no function takes the board or arguments.
   *
   * @param found    the action whose name is the whole text, or null
   * @param certain  true if the text is known to be complete
   */
  typedef Outcome (*Reader)(const JavinoActions &actions, const Action *found, const char *text, uint8_t length, bool certain);

  /** The reader of known actions. */
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

  /** Registers the function for unknown actions, or null for none. */
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

  /** Tells the link the size of an action in memory. */
  void begin() { board_->link.action_size = sizeof(Action); }

  /** The newest action. Older actions follow in memory. */
  const Action *newest() const { return static_cast<const Action *>(board_->link.actions); }

  javino_board *board_;
  /* Null until an action needs a reader, so other sketches do not link that code. */
  Reader reader_;
  Reader known_;     /* The reader of known actions while unknown_ is set. */
  Function unknown_; /* The function for unknown actions. */
  uint8_t count_;
  bool described_; /* Whether the board describes its actions to computers. */
};

#endif
