#include "JavinoActions.h"

#include "javino_literal.h"

bool JavinoActions::add(const char *name, Function function, Caller caller, uint8_t arguments) {
  if (!function)
    return false;
  Action *action = static_cast<Action *>(javino_board_take(memory_, sizeof(Action)));
  if (!action) {
    full_ = true;
    return false;
  }
  action->name = name;
  action->function = function;
  action->caller = caller;
  action->arguments = arguments;
  /* The newest comes first, so it takes the place of an older one of the same name. */
  first_ = action;
  count_++;
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
  const Action *action = first_;
  for (uint8_t i = count_; i > 0; i--, action++) {
    if (!begins(action->name, text, length))
      continue;
    bool longer = action->name[length];
    if (!certain && (longer || action->caller))
      return UNCERTAIN;
    if (!longer && !found)
      found = action;
  }
  if (!found && reader_)
    found = reader_(*this, text, length);
  if (!found)
    return REFUSED;
  if (found->caller)
    return found->caller(*found, JavinoArguments(text, length)) ? DONE : REFUSED;
  found->function();
  return DONE;
}

const JavinoActions::Action *JavinoActions::findByFunctor(const JavinoActions &actions, const char *text,
                                                          uint8_t length) {
  uint8_t n = javino_functor(text, length);
  const Action *action = actions.first_;
  for (uint8_t i = actions.count_; n && i > 0; i--, action++)
    if (action->caller && begins(action->name, text, n) && !action->name[n])
      return action;
  return NULL;
}

/** Whether a function may be called with these arguments. */
static bool takes(uint8_t wanted, const JavinoArguments &arguments) {
  return wanted == JavinoActions::ANY || wanted == arguments.count();
}

bool JavinoActions::callWithArguments(const Action &action, const JavinoArguments &arguments) {
  bool called = takes(action.arguments, arguments);
  if (called)
    reinterpret_cast<void (*)(const JavinoArguments &)>(action.function)(arguments);
  return called;
}

bool JavinoActions::askWithArguments(const Action &action, const JavinoArguments &arguments) {
  return takes(action.arguments, arguments) && reinterpret_cast<bool (*)(const JavinoArguments &)>(action.function)(arguments);
}

const char *JavinoActions::describe(uint8_t number, uint8_t *arguments) const {
  if (number >= count_)
    return NULL;
  const Action &action = first_[count_ - 1 - number];
  *arguments = action.arguments;
  return action.name;
}
