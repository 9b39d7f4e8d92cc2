"""Rules that the board itself watches."""
import re
from fractions import Fraction
from typing import NamedTuple, Optional

UNTIL = b"\x01"
REFLEX = 2
BLANK = b" "
NOT = b"!"
_OPERATORS = {b"<": lambda a, b: a < b, b">": lambda a, b: a > b, b"{": lambda a, b: a <= b, b"}": lambda a, b: a >= b,
              b"=": lambda a, b: a == b, NOT: lambda a, b: a != b}
_NUMBER = re.compile(rb"[+-]?[0-9]+(\.[0-9]+)?\Z")


class Condition(NamedTuple):
    place: int
    operator: bytes
    values: tuple  # a second value is used while the rule matches


class Rule(NamedTuple):
    number: int
    functor: bytes
    conditions: tuple
    reflex: Optional[bytes]


class Malformed(Exception):
    pass


def read(text):
    """Reads a rule's command. Returns a Rule, or the number of the rule to remove. 0 removes all rules."""
    number = text[0]
    if len(text) == 1:
        return number
    if number == 0:
        raise Malformed
    functor, rest = _word(text[1:])
    if not functor:
        raise Malformed
    conditions = []
    while rest and rest[0] != REFLEX:
        place, operator = rest[:1], rest[1:2]
        value, rest = _word(rest[2:])
        values = tuple(value.split(UNTIL, 1))
        if place not in tuple(b"%d" % i for i in range(1, 10)) or operator not in _OPERATORS or not all(values):
            raise Malformed
        if operator not in (b"=", NOT) and not all(map(_NUMBER.match, values)):
            raise Malformed
        conditions.append(Condition(int(place), operator, values))
    if rest == bytes([REFLEX]):
        raise Malformed
    return Rule(number, functor, tuple(conditions), rest[1:] or None)


def _word(text):
    """Returns the bytes before the first 00, and the bytes after it."""
    end = text.find(0)
    if end < 0:
        raise Malformed
    return text[:end], text[end + 1:]


def met(rule, percept, before=False):
    """Returns true if the percept has the rule's functor and matches all conditions. `before` tells whether the rule matched before."""
    functor, arguments = literal(percept)
    return functor == rule.functor and all(_holds(c, arguments, before) for c in rule.conditions)


def _holds(condition, arguments, before):
    if condition.place > len(arguments):
        return condition.operator == NOT
    argument, value = arguments[condition.place - 1], condition.values[-1 if before else 0]
    numbers = [bool(_NUMBER.match(text)) for text in (argument, value)]
    if numbers[0] != numbers[1]:
        return condition.operator == NOT
    compare = _OPERATORS[condition.operator]
    return compare(Fraction(argument.decode()), Fraction(value.decode())) if all(numbers) else compare(argument, value)


def literal(percept):
    """Returns the functor of a percept, and its arguments without surrounding blanks."""
    functor, rest = re.match(rb"([^(\[;]*)(.*)", percept, re.DOTALL).groups()
    if not rest.startswith(b"("):
        return functor.strip(BLANK), []
    arguments, begin, depth, quote, escaped = [], 1, 0, None, False
    for i in range(len(rest)):
        c = rest[i:i + 1]
        if quote:
            if escaped:
                escaped = False
            elif c == b"\\" and quote == b'"':
                escaped = True
            elif c == quote:
                quote = None
        elif c in b"\"'":
            quote = c
        elif c in b"([{":
            depth += 1
        elif c in b")]}":
            depth -= 1
        if not quote and (depth == 0 or depth == 1 and c == b","):
            arguments.append(rest[begin:i].strip(BLANK))
            begin = i + 1
            if depth == 0:
                break
    return functor.strip(BLANK), arguments
