"""Critical rules from the computer, which the board watches: conditions on percepts."""
from .literals import compare, functor_of, is_number, split

MAX_PERCEPT = 253
"""The largest percept in a report, in bytes, including its `;`."""

NO_REFLEX = 0
CARRIED_OUT = 1
NOT_CARRIED_OUT = 2

_UNTIL = "\x01"
_REFLEX = "\x02"


def _word(text, begin):
    """Returns the characters before the next 00, and the index after that 00. Returns (None, 0) if there is no 00."""
    end = text.find("\x00", begin)
    return (None, 0) if end < 0 else (text[begin:end], end + 1)


def read(text):
    """Reads a command's text without the rule's number. Returns (functor, conditions, reflex), or None if the text is no rule."""
    functor, at = _word(text, 0)
    if not functor:
        return None
    conditions = []
    while at < len(text) and text[at] != _REFLEX:
        place, operator = text[at], text[at + 1:at + 2]
        value, at = _word(text, at + 2)
        values = (value or "").split(_UNTIL, 1)
        if not "1" <= place <= "9" or operator not in ("<", ">", "{", "}", "=", "!") or "" in values:
            return None
        if operator not in ("=", "!") and not (is_number(values[0]) and is_number(values[-1])):
            return None
        conditions.append((int(place), operator, values))
    reflex = text[at + 1:]
    return None if at < len(text) and not reflex else (functor, conditions, reflex)


def _holds(condition, arguments, was_met):
    place, operator, values = condition
    value = values[-1 if was_met else 0]
    if place > len(arguments):
        return operator == "!"
    argument = arguments[place - 1]
    if is_number(argument) != is_number(value):
        return operator == "!"
    order = compare(argument, value) if is_number(value) else int(argument != value)
    if operator in "<>":
        return order < 0 if operator == "<" else order > 0
    if operator in "{}":
        return order <= 0 if operator == "{" else order >= 0
    return (order == 0) == (operator == "=")


def is_met(rule, percept, was_met=False):
    """Returns true if the percept has the rule's functor and matches all conditions. `was_met` tells whether the rule matched at the
    last look."""
    if functor_of(percept) != rule[0]:
        return False
    arguments = split(percept)[1]
    for condition in rule[1]:
        if not _holds(condition, arguments, was_met):
            return False
    return True


class Rules:
    """The rules of a session, at most `room` of them."""

    def __init__(self, room):
        self.room = room
        self._rules = []  # (number, rule), by number
        self._met = ()
        self._seen = []

    def __len__(self):
        return len(self._rules)

    def forget(self):
        """Removes all rules."""
        self._rules = []
        self._met = ()

    def set(self, text):
        """Carries out a command that sets or removes rules. Returns false if it refuses the command."""
        number = ord(text[0])
        if number == 0 and len(text) == 1:
            self.forget()
            return True
        rule = read(text[1:]) if len(text) > 1 else None
        others = [each for each in self._rules if each[0] != number]
        if number == 0 or len(text) > 1 and (rule is None or len(others) >= self.room):
            return False
        if rule:
            others.append((number, rule))
            others.sort(key=lambda each: each[0])
        self._rules = others
        self._met = tuple([met for met in self._met if met != number])
        return True

    def watches(self, functor):
        """Returns true if there is a rule for percepts with this functor."""
        for _, rule in self._rules:
            if rule[0].lstrip("~") == functor:
                return True
        return False

    def begin(self):
        """Begins a comparison of the sensors' percepts with the rules."""
        self._seen = []

    def newly_met(self, percept):
        """Returns (number, reflex) of each rule that begins to match with this percept. Such a rule matched no percept in the last
        look, and no earlier percept in this look."""
        found = []
        for number, rule in self._rules:
            was_met = number in self._met
            if number not in self._seen and is_met(rule, percept, was_met):
                self._seen.append(number)
                if not was_met:
                    found.append((number, rule[2]))
        return found

    def end(self):
        """Ends the look. Rules that matched no percept in this look can begin to match in the next."""
        self._met = tuple([number for number in self._seen if number in [each[0] for each in self._rules]])
