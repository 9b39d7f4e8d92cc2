#ifdef ARDUINO /* on other systems, only the core in C is used */

#include "JavinoActions.h"

#include "javino_literal.h"

/** Returns true if a page of the vocabulary has room for the name. */
static bool fits(const char *name) {
#ifdef JAVINO_VERSION_1_ONLY
  (void)name;
  return true;
#else
  return strlen(name) <= JAVINO_NAME_MAX;
#endif
}

bool JavinoActions::add(const char *name, Function function, Caller caller, uint8_t arguments) {
  uint8_t count = count_;
  Action *action = NULL;
  if (count < JAVINO_ACTIONS_MAX && fits(name))
    action = static_cast<Action *>(javino_board_take(board_, sizeof(Action)));
  if (!action) {
    leaveOut();
    return false;
  }
  action->named.name = name;
  action->named.arguments = arguments;
  action->function = function;
  action->caller = caller;
  /* The newest action comes first, so a search finds it before an older action with an equal name. */
  board_->link.actions = action;
  count_ = ++count;
#ifndef JAVINO_VERSION_1_ONLY
  if (described_)
    board_->link.action_count = count;
#endif
  return true;
}

void JavinoActions::leaveOut() {
  uint8_t lost = board_->link.actions_lost + 1;
  if (lost)
    board_->link.actions_lost = lost;
}

const char *JavinoActions::keep(const String &name) {
  const char *kept = strdup(name.c_str());
  if (!kept)
    leaveOut();
  return kept;
}

const char *JavinoActions::keep(const __FlashStringHelper *name) {
  const char *text = reinterpret_cast<const char *>(name);
  size_t size = strlen_P(text) + 1;
  char *kept = NULL;
  if (count_ < JAVINO_ACTIONS_MAX && size <= JAVINO_NAME_MAX + 1)
    kept = static_cast<char *>(javino_board_take_front(board_, static_cast<uint16_t>(size)));
  if (kept)
    memcpy_P(kept, text, size);
  else
    leaveOut();
  return kept;
}

void JavinoActions::carryOut(const __FlashStringHelper *name) const {
  JAVINO_COPY(copy, name);
  carryOut(copy);
}

/** Returns true if the name begins with this text, which may contain any bytes. */
static bool begins(const char *name, const char *text, uint8_t length) {
  for (; length > 0; length--)
    if (!*name || *name++ != *text++)
      return false;
  return true;
}

/** Carries an action out. Returns UNCERTAIN if the text may be truncated and a longer name begins with it. */
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
