"""The board's side of a session: frames in, frames out."""
from . import commands, parts, rules, vocabulary
from .frames import (ACK, ASK, BUSY, COMMANDS, COMMANDS_RESUME, CRITICAL, DESCRIBE, HELLO, REFUSED, VOCABULARY, WELCOME, Frame)
from .percepts import MAX_SHAPES, Writer

DONE, REFUSES, LATER = "done", "refused", "later"
NO_REFLEX, REFLEX_DONE, REFLEX_REFUSED = 0, 1, 2
PART_WITH_RULES = 12
MAX_CRITICAL_PERCEPT = 253
KINDS = b"(?)"  # in place of a list of functors; asks for the kinds of percepts
REVISION = 1


def described(kinds):
    """Returns the texts that describe the kinds of percepts."""
    return [b"?" + kind + b";" for kind in kinds]


class Board:
    """A board with a program. The program is an object with these members. `actions` holds pairs of a name and its number of arguments.
    `percepts(functors)` returns the present texts. `kinds` holds the kinds of percepts. `carry_out(text)` returns DONE, REFUSES or
    LATER.

    Numbers wrap after `numbers`, which is 256 in the protocol. Each part holds `part_size` bytes of an answer. If `part_size` is None,
    a part holds as many bytes as a frame can. While rules are set, a part holds at most twelve.
    """

    def __init__(self, program, credit=60, longest=255, max_rules=4, shapes=MAX_SHAPES, numbers=256, part_size=None):
        self.program = program
        self.actions = vocabulary.numbered(program.actions)
        self.credit, self.longest, self.max_rules, self.shapes, self.numbers = credit, longest, max_rules, shapes, numbers
        self.part_size = part_size
        self._begin(0)

    def _begin(self, session):
        self.session = session
        self.due = 0
        self.refused = self.busy = False
        self.known = 0
        self.writer = Writer(self.shapes)
        self.rules = {}
        self.met = set()

    def receive(self, frame):
        """Returns the frames that answer a frame."""
        if frame.kind == HELLO:
            if frame.number != self.session:
                self._begin(frame.number)
            return [self._welcome()]
        if not self.session:
            return [self._welcome()]
        if frame.kind == ASK:
            return self._ask(frame.number, frame.payload[:1], frame.payload[1:])
        if frame.kind == DESCRIBE:
            first = int.from_bytes(frame.payload[:1], "big")
            return [self._say(VOCABULARY, vocabulary.write_page(frame.number, self.actions, first))]
        self._commands(frame)
        return [self._say(ACK)]

    def end(self):
        """Takes a message of version 1. The message ends the session, because its sender knows of no session."""
        self._begin(0)

    def _say(self, kind, payload=b""):
        flags = (REFUSED if self.refused else 0) | (BUSY if self.busy else 0)
        return Frame(kind | flags, self.due, payload)

    def _welcome(self):
        left_out = min(255, len(self.program.actions) - len(self.actions))
        return self._say(WELCOME, bytes([self.session, self.credit, self.longest, self.max_rules, REVISION, left_out]))

    # ---- commands ----

    def _commands(self, frame):
        if frame.kind == COMMANDS_RESUME and frame.number == self.due:
            self.refused = False
        for i, command in enumerate(commands.read_row(frame.payload)):
            if self._is_next((frame.number + i) % self.numbers):
                self._handle(command)

    def _is_next(self, number):
        """Returns true if the command with this number is carried out now. Commands before `due` were handled. Commands after `due`
        are dropped."""
        return number == self.due and not self.refused and not self.busy

    def _handle(self, command):
        outcome = self._carry_out(command)
        if outcome == LATER:
            self.busy = True
        else:
            self._handled(outcome)

    def _handled(self, outcome):
        self.due = (self.due + 1) % self.numbers
        self.refused = outcome == REFUSES

    def report(self, outcome):
        """Takes the outcome of the action in progress. Ignores an action of an earlier session."""
        if not self.busy:
            return []
        self.busy = False
        self._handled(outcome)
        return [self._say(ACK)]

    def _carry_out(self, command):
        if command is commands.NOTHING:
            return DONE
        if isinstance(command, int):
            if command >= len(self.actions) or self.actions[command][1] not in (0, vocabulary.ANY_NUMBER):
                return REFUSES
            return self.program.carry_out(self.actions[command][0])
        if isinstance(command, commands.Rule):
            return self._set_rule(command.text)
        return self.program.carry_out(command)

    # ---- percepts ----

    def _ask(self, request, known, functors):
        self.known = min(int.from_bytes(known, "big"), len(self.writer.ids))
        if functors == KINDS:
            return self._answer(request, self.writer.write_without_ids(described(self.program.kinds)))
        return self._percepts(request, self.program.percepts(functors))

    def percepts_unasked(self):
        return self._percepts(0, self.program.percepts(b"")) if self.session else []

    def _percepts(self, request, texts):
        return self._answer(request, self.writer.write(texts, self.known))

    def _answer(self, request, answer):
        size = PART_WITH_RULES if self.rules else self.part_size
        return [self._say(kind, payload) for kind, payload in parts.split(request, answer, size)]

    # ---- rules ----

    def _set_rule(self, command):
        if not self.max_rules:
            return REFUSES
        try:
            rule = rules.read(command)
        except rules.Malformed:
            return REFUSES
        if rule == 0:
            self.rules = {}
        elif isinstance(rule, int):
            self.rules.pop(rule, None)
        elif len(self.rules) >= self.max_rules and rule.number not in self.rules:
            return REFUSES
        else:
            self.rules[rule.number] = rule
            self.met.discard(rule.number)
        self.met &= set(self.rules)
        return DONE

    def look(self):
        """Compares the sensors' percepts with the rules. Carries out the reflex of each rule that begins to match, and reports it."""
        texts, sent = [t for t in self.program.percepts(b"") if len(t) <= MAX_CRITICAL_PERCEPT], []
        for number in sorted(self.rules):
            rule = self.rules[number]
            text = next((t for t in texts if rules.met(rule, t, number in self.met)), None)
            if text is None:
                self.met.discard(number)
            elif number not in self.met:
                self.met.add(number)
                sent.append(self._say(CRITICAL, bytes([number, self._reflex(rule)]) + text))
        return sent

    def _reflex(self, rule):
        if rule.reflex is None:
            return NO_REFLEX
        return REFLEX_REFUSED if self.program.carry_out(rule.reflex) == REFUSES else REFLEX_DONE
