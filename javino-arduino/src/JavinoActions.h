#ifndef JAVINO_ACTIONS_H
#define JAVINO_ACTIONS_H

#include <Arduino.h>
#include <string.h>

#include "JavinoArguments.h"
#include "javino_board.h"

/**
 * The actions that a board knows, by name. They lie in the board's memory, seven bytes each on AVR; nothing is
 * allocated for them but where a name is a String. A name that is not a String is not copied, so it must last.
 */
class JavinoActions {
public:
  /** An action without arguments. */
  typedef void (*Function)();

  /** Any number of arguments. */
  static const uint8_t ANY = JAVINO_ANY;

  /** `act["ledOn"]`: the place of one action. */
  class Place {
  public:
    Place(JavinoActions &actions, const char *name) : actions_(actions), name_(name) {}

    /** Has the function called for the action whose whole text is the name. */
    void operator=(Function function) { actions_.add(name_, function); }

    /** Carries the action out, if there is one of that name. */
    void operator()() const { actions_.carryOut(name_, static_cast<uint8_t>(strlen(name_)), true); }

  private:
    JavinoActions &actions_;
    const char *name_;
  };

  /** The same, for a name that does not last. */
  class NamedPlace {
  public:
    NamedPlace(JavinoActions &actions, const String &name) : actions_(actions), name_(name) {}
    void operator=(Function function) { actions_.add(strdup(name_.c_str()), function); }
    void operator()() const { Place(actions_, name_.c_str())(); }

  private:
    JavinoActions &actions_;
    const String &name_;
  };

  explicit JavinoActions(javino_board *board) : board_(board), reader_(NULL), full_(false) {}


  Place operator[](const char *name) { return Place(*this, name); }
  NamedPlace operator[](const String &name) { return NamedPlace(*this, name); }

  /** How many actions there are. */
  uint8_t count() const { return board_->link.action_count; }

  /**
   * Whether an action has been left out because the memory was full, of which JavinoSized has more, or because
   * percepts had already been written.
   */
  bool full() const { return full_; }

private:
  friend class JavinoBoard;

  struct Action;

  /** Calls a function that takes arguments. False: it refuses the text. */
  typedef bool (*Caller)(const Action &action, const JavinoArguments &arguments);

  struct Action {
    javino_action named;
    Function function;
    Caller caller; /* null where the function takes no arguments */
  };

  enum Outcome : uint8_t {
    DONE,
    REFUSED,  /* there is no such action, or its arguments are wrong */
    UNCERTAIN /* a longer text that begins with this one could be for another action */
  };

  JavinoActions(const JavinoActions &);
  JavinoActions &operator=(const JavinoActions &);

  JAVINO_NOINLINE bool add(const char *name, Function function, Caller caller = NULL, uint8_t arguments = 0);
  bool addWithArguments(const char *name, Function function, Caller caller, uint8_t arguments) {
    reader_ = callByFunctor;
    return add(name, function, caller, arguments);
  }
  Outcome carryOut(const char *text, uint8_t length, bool certain) const;

  /** Calls the action that was found by its whole text or, null, by its functor. */
  static bool callByFunctor(const JavinoActions &actions, const Action *found, const char *text, uint8_t length);

  static bool callWithArguments(const Action &action, const JavinoArguments &arguments);
  static bool askWithArguments(const Action &action, const JavinoArguments &arguments);

  /** Tells the link how far the actions are apart. */
  void begin() { board_->link.action_size = sizeof(Action); }

  /** The newest action; behind it are the older ones. */
  const Action *newest() const { return static_cast<const Action *>(board_->link.actions); }

  javino_board *board_;
  /* Set with the first action that takes arguments, so that other sketches are spared the code. */
  bool (*reader_)(const JavinoActions &actions, const Action *found, const char *text, uint8_t length);
  bool full_;
};

#endif
