#ifdef ARDUINO /* elsewhere the core in C is all there is */

#include "JavinoActions.h"

#include "javino_literal.h"

bool JavinoActions::add(const char *name, Function function, Caller caller, uint8_t arguments) {
  if (!function)
    return false;
  Action *action = static_cast<Action *>(javino_board_take(board_, sizeof(Action)));
  if (!action) {
    full_ = true;
    return false;
  }
  action->named.name = name;
  action->named.arguments = arguments;
  action->function = function;
  action->caller = caller;
  /* The newest comes first, so it takes the place of an older one of the same name. */
  board_->link.actions = action;
  board_->link.action_count++;
  return true;
}

/** Whether a name begins with this text, in which any byte may stand. */
static bool begins(const char *name, const char *text, uint8_t length) {
  for (; length > 0; length--)
    if (!*name || *name++ != *text++)
      return false;
  return true;
}

/** Carries an action out, unless it is not certain that the text is whole and more of it could follow. */
JavinoActions::Outcome JavinoActions::carryOut(const char *text, uint8_t length, bool certain) const {
  const Action *found = NULL;
  const Action *action = newest();
  for (uint8_t i = count(); i > 0; i--, action++) {
    if (!begins(action->named.name, text, length))
      continue;
    bool longer = action->named.name[length];
    if (!certain && (longer || action->caller))
      return UNCERTAIN;
    if (!longer && !found)
      found = action;
  }
  if (reader_)
    return reader_(*this, found, text, length) ? DONE : REFUSED;
  if (!found)
    return REFUSED;
  found->function();
  return DONE;
}

bool JavinoActions::callByFunctor(const JavinoActions &actions, const Action *found, const char *text, uint8_t length) {
  uint8_t n = javino_functor(text, length);
  const Action *action = actions.newest();
  for (uint8_t i = actions.count(); !found && n && i > 0; i--, action++)
    if (action->caller && begins(action->named.name, text, n) && !action->named.name[n])
      found = action;
  if (!found)
    return false;
  if (found->caller)
    return found->caller(*found, JavinoArguments(text, length));
  found->function();
  return true;
}

/** Whether a function may be called with these arguments. */
static bool takes(uint8_t wanted, const JavinoArguments &arguments) {
  return wanted == JavinoActions::ANY || wanted == arguments.count();
}

bool JavinoActions::callWithArguments(const Action &action, const JavinoArguments &arguments) {
  bool called = takes(action.named.arguments, arguments);
  if (called)
    reinterpret_cast<void (*)(const JavinoArguments &)>(action.function)(arguments);
  return called;
}

bool JavinoActions::askWithArguments(const Action &action, const JavinoArguments &arguments) {
  return takes(action.named.arguments, arguments) && reinterpret_cast<bool (*)(const JavinoArguments &)>(action.function)(arguments);
}

#endif
