"""A board on a line. The board answers requests for percepts and carries out actions, in versions 1 and 2 of the protocol."""
from . import frames
from .clock import ticks_diff, ticks_ms
from .items import MAX_SHAPES, Shapes
from .lines import open_line, tell
from .literals import functor_of, split, term, to_bytes, to_text, value

ANY = 255
"""Any number of arguments."""

_MAX_ACTIONS = 126
_MAX_NAME = 250
_MAX_PARTS = 255
_PART = 253  # bytes of an answer in a part; an answer has at most 64,515 bytes
_PART_WITH_RULES = 12  # while rules are set; an answer then has at most 3,060 bytes
_PAGE = 252
_LOOK_MS = 5
_MAX_WAITING = 4096
_REQUEST = "getPercepts"
_KINDS = "(?)"  # in place of a list of functors; asks for the kinds of percepts
_NOTHING = None  # "no command", which only takes a number


class Refused(Exception):
    """Raise this in the function of an action to refuse the action. Returning False has the same effect."""


def _read_row(row):
    """Yields the commands of a payload: an action's number, a text, (text,) for a rule, or _NOTHING for "no command". Ends before an
    unreadable item."""
    at = 0
    while at < len(row):
        first = size = row[at]
        at += 1
        if 0x80 <= first < 0xFF:
            yield _NOTHING if first == 0xFE else first - 0x80
            continue
        if first in (0, 0xFF):
            size = row[at] if at < len(row) else 0
            at += 1
        if not 0 < size <= len(row) - at:
            return
        text = to_text(row[at:at + size])
        yield (text,) if first == 0xFF else text
        at += size


def _asks_for(functors, functor):
    """Returns true if a request with this list of functors, such as `(dist,light)`, asks for `functor`. A request without a list asks
    for all."""
    if "(" not in functors and "," not in functors:
        return True
    for before in "(,":
        for behind in ",)":
            if before + functor + behind in functors:
                return True
    return False


class _Acts:
    """Registers actions: `board.act["ledOn"] = led_on`"""

    def __init__(self, board):
        self._board = board

    def __setitem__(self, name, function):
        self._board.on_action(name, function)


class Board:
    """A board on a line.

    `line` is the name of a line (see `open_line`), or an object with `read` and `write`. A UART of MicroPython or CircuitPython and
    a pyserial port are such objects. The default is standard input and output. On a microcontroller the default is the USB port.
    `baud` is the rate of a named serial port. If the rate is known, the board waits between the parts of a long answer. The report
    of a reflex can then overtake parts. A silence of 100 ms ends an unfinished frame. Below 2000 baud the silence is 20 byte times.
    `credit` is the size of the port's receive buffer in bytes. `longest` is the longest payload of a frame in bytes. `shapes` is
    the number of shapes of percepts that the board sends as digits. `ticks` is a clock of milliseconds.

    Call a board from only one thread, never from an interrupt.
    """

    def __init__(self, line=None, baud=None, credit=None, longest=frames.MAX_PAYLOAD, shapes=MAX_SHAPES, ticks=ticks_ms):
        self.line = open_line(line, baud)
        self.act = _Acts(self)
        self._baud = baud
        self._credit = credit or getattr(self.line, "credit", 63)
        self._longest = longest
        self._room = shapes
        self._ticks = ticks
        self._actions = []  # (name, arguments, function), by number
        self._perceive = None
        self._kinds = []
        self._receiver = frames.Receiver(self, frames.idle_ms(baud), longest)
        self._running = False
        self._inbox = b""  # bytes that arrived while a registered function ran
        self._texts = []  # written percepts that are not sent yet
        self._waiting = 0  # length of the written percepts that no request has asked for
        self._asked = None  # list of functors of the present request; None without a request
        self._version = 0  # version of the present request, or 0
        self._doubtful = None  # an action of version 1 whose text may be truncated
        self._rules = None
        self._is_looking = False
        self._looked = self._before = self._heard = self._free_at = ticks()
        self._silence = 0
        self._lost = None
        self._is_lost = False
        self._tokens = 0
        self._begin(0)

    def _begin(self, session):
        self._session = self._receiver.session = session
        self._due = 0
        self._is_refused = self._is_busy = False
        self._known = 0
        self._shapes = Shapes(self._room)
        self._parts = []
        self._next_ask = None
        self._open = 0  # number from `later` of the action without an outcome, or 0
        self._outcome = None
        self._in_hand = False
        if self._rules is not None:
            self._rules.forget()

    # ---- functions that a program registers ----

    def on_action(self, name, function=None, arguments=0):
        """Registers the function of an action. The function gets the values of the action's arguments: int, float, or str.

        `arguments` is the number of the action's arguments, or ANY. The board refuses an action with another number. The function
        refuses the action by returning False or raising Refused. After any other exception, the board refuses the action and `run`
        raises that exception.

        Without a function, on_action is a decorator: `@board.on_action("speed", arguments=1)`, or `@board.on_action("speed", 1)`.

        A second registration of a name replaces the function.
        """
        if isinstance(function, int):
            function, arguments = None, function
        if function is not None and not callable(function):
            raise TypeError("on_action(%r, %r): give the function behind the name, or the number of arguments to decorate one"
                            % (name, function))
        if function is None:
            return lambda decorated: self.on_action(name, decorated, arguments)
        if split(name) != (name, [], True):
            raise ValueError("%r is no action's name; give only the functor, and the number of its arguments as arguments=1" % name)
        if len(to_bytes(name)) > _MAX_NAME:
            raise ValueError("an action's name has at most %d characters, unlike %r" % (_MAX_NAME, name))
        for i in range(len(self._actions)):
            if self._actions[i][0] == name:
                self._actions[i] = (name, arguments, function)
                return function
        if len(self._actions) == _MAX_ACTIONS:
            raise ValueError("a board has at most %d actions, there is no room for %s" % (_MAX_ACTIONS, name))
        self._actions.append((name, arguments, function))
        return function

    def perceive(self, function, *kinds):
        """Registers the function that writes percepts when a computer asks for them. Returns that function. `perceive` is also a
        decorator.

        `kinds` are texts that describe the percepts to computers: `perceive(look, "dist(front|left, cm 0..400)")`, or
        `@board.perceive("dist(front|left, cm 0..400)", "ready")`. An argument is `_` for anything, a choice such as `front|left` or
        `0|1`, or a range with or without a unit: `cm 0..400`, `-40..125`, `% ..`.
        """
        if isinstance(function, str):
            kinds = (function,) + kinds
            return lambda decorated: self.perceive(decorated, *kinds)
        self._perceive = function
        self._kinds = [b"?" + to_bytes(kind) + b";" for kind in kinds]
        return function

    def watch_rules(self, room=8):
        """Lets the board watch up to `room` critical rules from the computer. `run` then calls the function given to `perceive`, at
        most every 5 ms. In these calls `wants` is true only for functors in rules. Call watch_rules before the first `run`."""
        from .rules import Rules  # boards without rules do not load this module
        self._rules = Rules(room)

    def on_link_lost(self, ms, function):
        """Registers a function for a lost link. The board calls the function once if nothing valid has arrived for `ms` milliseconds.
        The board calls it again only after something valid has arrived. With 0 ms, the board never calls the function."""
        self._silence, self._lost = ms, function
        self._heard, self._is_lost = self._ticks(), False

    # ---- percepts ----

    def wants(self, functor):
        """Returns true if the present request asks for percepts with this functor. If not, the sensor need not be read."""
        functor = functor.lstrip("~")
        if self._is_looking:
            return self._rules.watches(functor)
        return self._asked is None or _asks_for(self._asked, functor)

    def percept(self, functor, *values):
        """Writes a percept: `percept("dist", "front", 30)` is `dist(front,30)`. `term` describes the values.

        Returns False if the percept will not be sent: it is too long for version 1, or too many unasked percepts wait.
        """
        if not self.wants(functor):
            return True
        return self._write(functor + "(" + ",".join([term(each) for each in values]) + ")" if values else functor)

    def add_percept(self, text):
        """Writes a percept, given as text without the `;`. Returns the result of `percept`."""
        return not self.wants(functor_of(text)) or self._write(text)

    def _write(self, text):
        data = to_bytes(text) + b";"
        if self._is_looking:
            self._compare(text, data)
            return True
        if self._version == 1 and len(data) > frames.MAX_PAYLOAD:
            return False
        if self._asked is None:
            if self._waiting + len(data) > _MAX_WAITING:
                return False
            self._waiting += len(data)
        self._texts.append(data)
        return True

    def clear_percepts(self):
        """Forgets the written percepts that are not sent yet."""
        self._texts = []
        self._waiting = 0

    def send_percepts(self):
        """Sends the written percepts unasked. `run` sends the answer to a request."""
        if self._asked is None and not self._is_looking:
            self._send_texts(0, 2 if self._session else 1)
            self._send_parts()

    def _answer(self, request, functors, version):
        self._asked, self._version = functors, version
        try:
            if self._perceive:
                self._perceive()
            self._send_texts(request, version)
        finally:
            self._asked, self._version = None, 0
            self.clear_percepts()
        self._send_parts()

    def _send_texts(self, request, version):
        texts = self._texts
        self.clear_percepts()
        if version == 1:
            self._send_messages(texts)
            return
        self._send_as_fits(request, texts, lambda texts: self._shapes.write(texts, self._known), "percepts")

    def _send_as_fits(self, request, texts, write, words):
        """Sends the answer that `write` makes from these texts. If one answer cannot hold all texts, sends only the first texts and
        warns."""
        limit = _MAX_PARTS * (_PART_WITH_RULES if self._rules else _PART)
        answer = write(texts)
        if len(answer) > limit:
            tell("an answer has at most %d bytes%s: the last %s are left out" % (limit, " with rules" if self._rules else "", words))
        while len(answer) > limit:
            texts = texts[:len(texts) * 3 // 4]
            answer = write(texts)
        self._send_answer(request, answer)

    def _send_answer(self, request, answer):
        size = _PART_WITH_RULES if self._rules else _PART
        if len(answer) <= (size if self._rules else size + 1):
            self._parts.append((frames.PERCEPTS, bytes((request,)) + answer))
        else:
            count = (len(answer) + size - 1) // size
            for i in range(count):
                kind = frames.PART if i < count - 1 else frames.LAST_PART
                self._parts.append((kind, bytes((request, i)) + answer[i * size:i * size + size]))

    def _send_messages(self, texts):
        """Sends messages of version 1, each with whole percepts."""
        message = b""
        for text in texts:
            if len(text) > frames.MAX_PAYLOAD:
                continue
            if len(message) + len(text) > frames.MAX_PAYLOAD:
                self._put(frames.frame1(message))
                message = b""
            message += text
        self._put(frames.frame1(message))

    def _send_parts(self):
        """Sends the waiting parts of answers. If rules are set, waits until the previous part has left, and checks the rules after
        each part."""
        while self._parts and (not self._rules or self._has_left()):
            kind, payload = self._parts.pop(0)
            self._say(kind, payload)
            if self._parts:
                self._look()

    # ---- actions ----

    def carry_out(self, text):
        """Carries out the action with this text. Returns true if the action was carried out."""
        functor, arguments, is_whole = split(text)
        if not is_whole:
            return False
        for name, count, function in self._actions:
            if name == functor and count in (len(arguments), ANY):
                return self._call(function, [value(each) for each in arguments])
        return False

    @staticmethod
    def _call(function, arguments):
        try:
            return function(*arguments) is not False
        except Refused:
            return False

    def later(self):
        """Call this in an action's function to report the outcome later, with `done`. Until then the board answers requests, but
        carries out no other action of version 2. Returns a number for `done`. In version 1 nobody waits for an outcome, so the
        number is 0."""
        if not self._in_hand:
            return 0
        self._tokens += 1
        self._open = self._tokens
        return self._open

    def done(self, later, carried_out=True):
        """Reports the outcome of an action whose function called `later`. Returns false if nobody waits for the outcome: the number is
        0, or the computer has begun a new session."""
        if not later or later != self._open:
            return False
        self._open = 0
        if self._in_hand:
            self._outcome = carried_out
        else:
            self._is_busy = False
            self._settle(carried_out)
            self._say(frames.ACK)
        return True

    def _commands(self, kind, number, row):
        if kind == frames.RESUME and number == self._due:
            self._is_refused = False
        try:
            for command in _read_row(row):
                if number == self._due and not self._is_refused and not self._is_busy:
                    self._handle(command)
                number = (number + 1) & 255
        finally:
            self._say(frames.ACK)

    def _handle(self, command):
        self._in_hand, self._outcome, outcome = True, None, False
        try:
            outcome = self._command(command)
            if self._outcome is not None:
                outcome = self._outcome
            self._is_busy = bool(outcome and self._open)
        finally:
            self._in_hand = False
            if not self._is_busy:
                self._open = 0
                self._settle(outcome)

    def _settle(self, is_done):
        self._due = (self._due + 1) & 255
        self._is_refused = not is_done

    def _command(self, command):
        if command is _NOTHING:
            return True
        if isinstance(command, tuple):
            return self._rules is not None and self._rules.set(command[0])
        if isinstance(command, str):
            return self.carry_out(command)
        if command >= len(self._actions) or self._actions[command][1] not in (0, ANY):
            return False
        return self._call(self._actions[command][2], [])

    # ---- rules ----

    def _look(self):
        """Compares the sensors' percepts with the rules, at most every 5 ms."""
        now = self._ticks()
        if not self._rules or not self._perceive or ticks_diff(now, self._looked) < _LOOK_MS:
            return
        self._looked = now
        self._is_looking = True
        self._rules.begin()
        try:
            self._perceive()
        finally:
            self._is_looking = False
        self._rules.end()

    def _compare(self, text, data):
        for number, reflex in self._rules.newly_met(text) if len(data) <= 253 else ():
            outcome = 0
            if reflex:
                self._is_looking = False  # percepts that the reflex's function writes must not be compared
                try:
                    outcome = 1 if self.carry_out(reflex) else 2
                finally:
                    self._is_looking = True
            self._say(frames.CRITICAL, bytes((number, outcome)) + data)

    # ---- the line ----

    def run(self):
        """Handles the bytes that have arrived: answers requests, carries out actions, reports a lost link. Call this in every cycle of
        the program. Within a registered function, `run` only stores the bytes, so the receive buffer does not overflow. Raises
        LineGone if the line is gone for good."""
        if self._running:
            if len(self._inbox) < _MAX_WAITING:
                self._inbox += self.line.read() or b""
            return
        self._running = True
        try:
            self._round()
        finally:
            self._running = False

    def _round(self):
        now = self._ticks()
        data = self._inbox + (self.line.read() or b"")
        self._inbox = b""
        if data:
            self._receiver.receive(data, now)
        else:
            self._receiver.idle(now, ticks_diff)
        self._look()
        self._send_parts()
        if self._next_ask and not self._parts:
            number, payload = self._next_ask
            self._next_ask = None
            self._ask(number, payload)
        self._before = now
        if self._silence and not self._is_lost and ticks_diff(now, self._heard) >= self._silence:
            self._is_lost = True
            self._lost()

    def wait(self, ms):
        """Waits until something arrives, at most `ms` milliseconds. Waits less if silence may end a frame, or if rules watch sensors."""
        if self._parts:
            ms = min(ms, 1)
        elif self._rules or self._receiver.is_waiting():  # `_rules` is true while rules are set
            ms = min(ms, _LOOK_MS)
        self.line.wait(ms)

    def run_forever(self, each_round=None, ms=20):
        """Runs the board forever. Calls `each_round` in every cycle. A cycle waits at most `ms` milliseconds."""
        while True:
            self.run()
            if each_round:
                each_round()
            self.wait(ms)

    def _put(self, data):
        if self._baud:
            now = self._ticks()
            begin = now if self._has_left() else self._free_at
            self._free_at = begin + len(data) * 10000 // self._baud + 1
        self.line.write(data)

    def _has_left(self):
        """Returns true if all written bytes have left, at the line's rate."""
        return not self._baud or ticks_diff(self._free_at, self._ticks()) <= 0

    def _say(self, kind, payload=b""):
        if self._is_refused:
            kind |= frames.REFUSED
        if self._is_busy:
            kind |= frames.BUSY
        self._put(frames.frame2(kind, self._due, payload, self._session))

    # ---- frames from the receiver ----

    def take1(self, payload):
        """Handles a message of version 1. The sender has no session, so an earlier program's session ends."""
        self._note_valid()
        if self._session:
            self._begin(0)
        text = to_text(payload)
        if text.startswith(_REQUEST) and text[len(_REQUEST):len(_REQUEST) + 1] in ("", "("):
            self._answer(0, text[len(_REQUEST):], 1)
            return
        for name, _, _ in self._actions:
            if name != text and name.startswith(text):
                self._doubtful = text  # a damaged length may have truncated the text
                return
        self.carry_out(text)

    def followed(self, rightly):
        """Called when the following bytes show whether the last message of version 1 was read correctly."""
        text, self._doubtful = self._doubtful, None
        if text is not None and rightly:
            self.carry_out(text)

    def take2(self, kind, number, payload):
        self._note_valid()
        if kind == frames.HELLO and number != self._session:  # a repeated HELLO begins no new session
            self._begin(number)
        if kind == frames.HELLO or not self._session:
            rules = 0 if self._rules is None else self._rules.room
            self._say(frames.WELCOME, bytes((self._session, self._credit, self._longest, rules, frames.REVISION, 0)))
        elif kind == frames.ASK:
            if self._parts:
                self._next_ask = number, payload
            else:
                self._ask(number, payload)
        elif kind == frames.DESCRIBE:
            self._describe(number, payload[0] if payload else 0)
        else:
            self._commands(kind, number, payload)

    def _ask(self, number, payload):
        self._known = min(payload[0] if payload else 0, len(self._shapes))
        functors = to_text(payload[1:])
        if functors == _KINDS:
            self._send_as_fits(number, self._kinds, self._shapes.write_without_ids, "kinds of percepts")
            self._send_parts()
        else:
            self._answer(number, functors, 2)

    def _describe(self, number, first):
        page = b""
        for name, arguments, _ in self._actions[first:]:
            name = to_bytes(name)
            if len(page) + 2 + len(name) > _PAGE:
                break
            page += bytes((arguments, len(name))) + name
        self._say(frames.VOCABULARY, bytes((number, first, len(self._actions))) + page)

    def _note_valid(self):
        self._heard = self._before
        self._is_lost = False
