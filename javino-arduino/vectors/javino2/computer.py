"""The computer's end of a line: a session with clocks, waiting commands, and the board's credit."""
from typing import NamedTuple, Optional

from . import commands
from .frames import FROM_BOARD, HELLO, Frame, Receiver, encode
from .session import Session
from .window import MAX_ROW

FIRST_HELLO, NEXT_HELLO = 60, 250
MIN_TIMEOUT, MAX_TIMEOUT, BUSY_TIMEOUT = 60, 500, 250
REPETITIONS, SILENCE = 4, 2000
NOT_SENT = "not sent"


class Waiting(NamedTuple):
    command: object
    deadline: Optional[float]


class Carrier(NamedTuple):
    """A frame that is not fully acknowledged: the number of its unacknowledged commands, and its length on the line."""
    commands: int
    bytes: int


def nonces(choose):
    """Returns a function that makes nonces with `choose(low, high)`. A HELLO with such a nonce contains no `f` and needs no escape."""
    def next_nonce(last):
        while True:
            nonce = choose(1, 255)
            frame = encode(Frame(HELLO, nonce))
            if nonce != last and b"f" not in frame and len(frame) == 6:
                return nonce
    return next_nonce


class Computer:
    """Takes bytes in `receive` and returns bytes from `poll`. Outcomes and answers are in `session`. A byte takes `byte_time`."""

    def __init__(self, next_nonce, byte_time, now):
        self.session = Session(next_nonce)
        self.receiver = Receiver(FROM_BOARD, max(100, 20 * byte_time))
        self.byte_time = byte_time
        self.waiting = []
        self.deadlines = {}
        self.sending = []
        self.round_trip = None
        self.hellos, self.due_at = 0, now
        self._begin(now)

    def _begin(self, now):
        self.carriers, self.ask_bytes = [], 0
        self.timed = None  # (number of commands until the measurement ends, its begin)
        self.backoff = 1
        self.repetitions, self.repeated_at, self.heard_at = 0, None, now

    # ---- requests of the program ----

    def submit(self, command, deadline=None):
        self.waiting.append(Waiting(command, deadline))

    def ask(self):
        """Asks for percepts. The answer appears in the session's `answers`. Returns false if no session is open."""
        if not self.session.open:
            return False
        frame = self.session.ask()
        self.ask_bytes = len(encode(frame, self.session.nonce))
        self._send(frame)
        return True

    # ---- time and bytes ----

    def poll(self, now):
        """Returns the bytes to send now."""
        self._look_at_deadlines(now)
        if now >= self.due_at:
            self._time_over(now)
        if self.session.open:
            self._send_waiting(now)
        sending, self.sending = b"".join(self.sending), []
        return sending

    def receive(self, data, now):
        for byte in data:
            self.receiver.nonce = self.session.nonce if self.session.open else 0
            self.receiver.receive(bytes([byte]), now)
            frames, self.receiver.frames = self.receiver.frames, []
            for frame in frames:
                self._heard(frame, now)

    def _heard(self, frame, now):
        session = self.session
        was_open, out, answers = session.nonce if session.open else None, len(session.window.out), len(session.answers)
        lately = self.repeated_at is not None and now - self.repeated_at < self._timeout() / 3
        self.heard_at, self.repetitions = now, 0
        replies = session.receive(frame, lately)
        if len(session.answers) > answers:
            self.ask_bytes = 0
        if session.open and was_open != session.nonce:
            self._begin(now)
        elif was_open and not session.open:
            self.hellos = 1
            self.due_at = now + FIRST_HELLO
        elif session.open and len(session.window.out) < out:
            self._acknowledged(out - len(session.window.out), now)
        for reply in replies:
            self._repeat(reply, now) if session.open else self._send(reply)

    def _acknowledged(self, count, now):
        self.backoff = 1
        if self.timed:
            self.timed = (self.timed[0] - count, self.timed[1])
            if self.timed[0] <= 0:
                taken = now - self.timed[1]
                self.round_trip = taken if self.round_trip is None else self.round_trip + (taken - self.round_trip) / 8
                self.timed = None
        while self.carriers and count >= self.carriers[0].commands:
            count -= self.carriers.pop(0).commands
        if count:
            self.carriers[0] = self.carriers[0]._replace(commands=self.carriers[0].commands - count)
        self._start_timer(now)

    def _timeout(self):
        base = 2 * (self.round_trip or 0) + self.byte_time * sum(c.bytes for c in self.carriers)
        timeout = min(max(base, MIN_TIMEOUT) * self.backoff, max(base, MAX_TIMEOUT))
        return max(timeout, BUSY_TIMEOUT) if self.session.window.busy else timeout

    def _start_timer(self, now):
        self.due_at = now + self._timeout()

    def _time_over(self, now):
        if not self.session.open:
            self._send(self.session.hello())
            self.hellos += 1
            self.due_at = now + (FIRST_HELLO if self.hellos == 1 else NEXT_HELLO)
        elif self.session.window.out:
            if self.repetitions >= REPETITIONS and now - self.heard_at >= SILENCE:
                self._send(self.session.give_up())
                self.hellos, self.due_at = 1, now + FIRST_HELLO
                return
            self.backoff *= 2
            self._repeat(self.session.repeat(), now)

    def _repeat(self, frame, now):
        count = len(commands.read_row(frame.payload))
        carrier = Carrier(count, len(encode(frame, self.session.nonce)))
        while self.carriers and count >= self.carriers[0].commands:
            count -= self.carriers.pop(0).commands
        if count:
            self.carriers[0] = self.carriers[0]._replace(commands=self.carriers[0].commands - count)
        self.carriers.insert(0, carrier)
        self.timed = None
        self.repetitions += 1
        self.repeated_at = now
        self._send(frame)
        self._start_timer(now)

    def _send_waiting(self, now):
        window = self.session.window
        while self.waiting and window.room():
            row = []
            for waiting in self.waiting[:window.room()]:
                if row and len(commands.write_row(row + [waiting.command])) > MAX_ROW:
                    break
                row.append(waiting.command)
            in_use = self.ask_bytes + sum(c.bytes for c in self.carriers)
            if in_use and in_use + 1 + 2 * (len(commands.write_row(row)) + 5) > self.session.welcome[1]:  # all bytes may be escaped
                return
            sent, self.waiting = self.waiting[:len(row)], self.waiting[len(row):]
            self.deadlines.update({w.command: w.deadline for w in sent if w.deadline is not None})
            if not window.out:
                self.timed, self.repeated_at = (len(row), now), None
            frame = window.send(row)
            self.carriers.append(Carrier(len(row), len(encode(frame, self.session.nonce))))
            self._send(frame)
            if len(window.out) == len(row):
                self._start_timer(now)

    def _look_at_deadlines(self, now):
        for waiting in [w for w in self.waiting if w.deadline is not None and now > w.deadline]:
            self.waiting.remove(waiting)
            self.session.outcomes.append((waiting.command, NOT_SENT))
        for command in [c for c, deadline in self.deadlines.items() if now > deadline]:
            del self.deadlines[command]
            self.session.window.time_over(command)

    def _send(self, frame):
        self.sending.append(encode(frame, self.session.nonce))
