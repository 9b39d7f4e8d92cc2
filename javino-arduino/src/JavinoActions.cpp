#ifdef ARDUINO /* elsewhere the core in C is all there is */

#include "JavinoActions.h"

#include "javino_literal.h"

bool JavinoActions::add(const char *name, Function function, Caller caller, uint8_t arguments) {
  if (!function)
    return false;
  Action *action = static_cast<Action *>(javino_board_take(board_, sizeof(Action)));
  uint8_t count = count_;
  if (!action || count == JAVINO_ACTIONS_MAX) {
    board_->link.actions_lost++;
    return false;
  }
  action->named.name = name;
  action->named.arguments = arguments;
  action->function = function;
  action->caller = caller;
  /* The newest comes first, so it takes the place of an older one of the same name. */
  board_->link.actions = action;
  count_ = ++count;
  if (described_)
    board_->link.action_count = count;
  return true;
}

const char *JavinoActions::keep(const __FlashStringHelper *name) {
  const char *text = reinterpret_cast<const char *>(name);
  uint16_t size = static_cast<uint16_t>(strlen_P(text) + 1);
  char *kept = static_cast<char *>(javino_board_take_front(board_, size));
  if (kept)
    memcpy_P(kept, text, size);
  else
    board_->link.actions_lost++;
  return kept;
}

void JavinoActions::FlashPlace::operator()() const {
  JAVINO_COPY(name, name_);
  Place(actions_, name)();
}

/** Returns true if a name begins with this text, which may hold any bytes. */
static bool begins(const char *name, const char *text, uint8_t length) {
  for (; length > 0; length--)
    if (!*name || *name++ != *text++)
      return false;
  return true;
}

/** Carries an action out, unless the text may be cut short and a longer action begins with it. */
JavinoActions::Outcome JavinoActions::carryOut(const char *text, uint8_t length, bool certain) const {
  const Action *found = NULL;
  const Action *action = newest();
  for (uint8_t i = count_; i > 0; i--, action++) {
    if (!begins(action->named.name, text, length))
      continue;
    bool longer = action->named.name[length];
    if (!certain && (longer || action->named.arguments))
      return UNCERTAIN;
    if (!longer && !found)
      found = action;
  }
  if (reader_)
    return reader_(*this, found, text, length, certain);
  if (!found)
    return UNKNOWN;
  found->function();
  return DONE;
}

JavinoActions::Outcome JavinoActions::call(const JavinoActions &actions, const Action &action, const JavinoArguments &arguments) {
  if (action.caller)
    return action.caller(action.function, actions.board(), arguments) ? DONE : REFUSED;
  action.function();
  return DONE;
}

JavinoActions::Outcome JavinoActions::callFound(const JavinoActions &actions, const Action *found, const char *text, uint8_t length, bool) {
  return found ? call(actions, *found, JavinoArguments(text, length)) : UNKNOWN;
}

JavinoActions::Outcome JavinoActions::callByFunctor(const JavinoActions &actions, const Action *found, const char *text, uint8_t length,
                                                    bool) {
  JavinoArguments arguments(text, length);
  uint8_t given = 0;
  if (!found) {
    uint8_t n = javino_functor(text, length);
    const Action *action = actions.newest();
    for (uint8_t i = actions.count_; !found && n && i > 0; i--, action++)
      if (action->caller && begins(action->named.name, text, n) && !action->named.name[n])
        found = action;
    given = arguments.count();
  }
  if (!found || (found->named.arguments != ANY && found->named.arguments != given))
    return UNKNOWN;
  return call(actions, *found, arguments);
}

#endif
