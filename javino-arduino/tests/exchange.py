#!/usr/bin/env python3
"""Lets both ends of the reference talk over a line that changes, loses and doubles bytes, with restarts, refusals and late outcomes.

    exchange.py [COMMANDS] [SEED]   6000 commands and seed 1 if not said otherwise
    exchange.py --defects           with each of some defects in the reference; expects to find each

Checks that every command is carried out once and in order, that outcomes are true, and that the board sent each believed answer. Time is
simulated.
"""
import pathlib
import random
import sys
from unittest.mock import patch

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "vectors"))
import mutations  # noqa: E402
from javino2.board import DONE, LATER, REFUSES, Board  # noqa: E402
from javino2.computer import NOT_SENT, Computer, nonces  # noqa: E402
from javino2.frames import ASK, Frame, encode  # noqa: E402
from javino2.line import Line  # noqa: E402
from javino2 import parts, window  # noqa: E402


class Failure(Exception):
    pass


def nothing(data):
    return False


def has_hello(data):
    return b"\xa5\x00\x10" in data


class Wire:
    """One direction: bytes arrive after a while, at the rate of the line; each is damaged with a probability, and bytes sent at once come
    once more later with another, if `is_copied` is true for them."""

    def __init__(self, rng, rate, harm, is_copied):
        self.rng, self.rate, self.harm, self.is_copied = rng, rate, harm, is_copied
        self.bytes = []
        self.copies = []  # (when they arrive, bytes)

    def send(self, data, now):
        if data and self.is_copied(data) and self.rng.random() < 0.2:
            self.copies.append((now + self.rng.randrange(150), data))
        at = max([now] + [self.bytes[-1][0]] if self.bytes else [now])
        for byte in data:
            at += 1 / self.rate
            kind = self.rng.random() / self.harm if self.harm else 1
            if kind < 0.8:
                byte ^= 1 << self.rng.randrange(8)
            if not 0.8 <= kind < 0.9:
                self.bytes.append((at, byte))
            if 0.9 <= kind < 1:
                self.bytes.append((at, byte))

    def arrived(self, now):
        n = 0
        while n < len(self.bytes) and self.bytes[n][0] <= now:
            n += 1
        arrived, self.bytes = bytes(b for _, b in self.bytes[:n]), self.bytes[n:]
        copies = b"".join(data for at, data in self.copies if at <= now)
        self.copies = [copy for copy in self.copies if copy[0] > now]
        return arrived + copies


class Program:
    """Action number n is `c(n)`; its outcome is drawn when it comes."""

    actions = [(b"c", 1)]

    def __init__(self, rng, refusals, late):
        self.rng, self.refusals, self.late = rng, refusals, late
        self.carried_out, self.refused, self.said = [], set(), {}
        self.open = None  # (text, when its outcome is known)
        self.now = 0

    def carry_out(self, text):
        if self.rng.random() < self.refusals:
            self.refused.add(text)
            return REFUSES
        self.carried_out.append(text)
        if self.rng.random() < self.late:
            self.open = (text, self.now + self.rng.randrange(400))
            return LATER
        return DONE

    def percepts(self, functors):
        draw = self.rng.randrange
        self.texts = [b"p%d(%d,-%d.%02d);" % (i, draw(1000), i, draw(100)) for i in range(draw(8))]
        return self.texts


class Exchange:
    def __init__(self, rng, rate, harm, refusals, late, restarts, copies):
        self.rng, self.restarts = rng, restarts
        self.now = 0
        self.program = Program(rng, refusals, late)
        self.to_board, self.to_computer = Wire(rng, rate, harm, copies), Wire(rng, rate, harm, copies)
        self.byte_time = 1 / rate
        self.computer = self._computer()
        self.outcomes, self.believed, self.nonce = {}, 0, 0
        self.news_at = 0
        self._boot()

    def _computer(self):
        return Computer(nonces(self.rng.randint), self.byte_time, self.now)

    def _boot(self):
        self.board, self.line = Board(self.program, part_size=40), Line(self._board_receives, now=self.now)
        self.program.open = None

    def run(self, commands):
        submitted, texts = 0, []
        while len(self.outcomes) < commands:
            self.now += 1
            self.program.now = self.now
            while submitted < commands and submitted - len(self.outcomes) < 12 and self.rng.random() < 0.3:
                text = b"c(%d)" % submitted
                self.computer.submit(text, self.now + 1500 if self.rng.random() < 0.2 else None)
                submitted += 1
                texts.append(text)
            if self.rng.random() < 0.02:
                self.computer.ask()
            self._restart(texts)
            self._step()
            if self.now - self.news_at > 20_000:
                raise Failure("no outcome for 20 s")
        self._check_order()

    def _restart(self, texts):
        if self.rng.random() < self.restarts:
            self._boot()
        if self.rng.random() < self.restarts:
            self._take()
            window_out = {entry.command for entry in self.computer.session.window.out}
            for text in texts:
                if text not in self.outcomes:
                    self.outcomes[text] = window.UNCONFIRMED if text in window_out else NOT_SENT
            last = self.computer.session.nonce
            while self.computer.session.nonce == last:
                self.computer = self._computer()

    def _step(self):
        self.to_board.send(self.computer.poll(self.now), self.now)
        self.line.receive(self.to_board.arrived(self.now), self.now)
        if self.program.open and self.now >= self.program.open[1]:
            self._report()
        for byte in self.to_computer.arrived(self.now):
            self.nonce = self.computer.session.nonce  # of what this byte ends
            self.computer.receive(bytes([byte]), self.now)
            self._take()

    def _board_receives(self, frame):
        if not isinstance(frame, Frame):
            raise Failure(f"a frame of version 1 was never sent: {frame}")
        begun = self.program.open
        replies = self.board.receive(frame)
        self.line.session = self.board.session
        if not self.board.busy and self.program.open is begun:
            self.program.open = None
        if frame.kind == ASK and self.board.session:
            self.program.said.setdefault((self.board.session, frame.number), []).append(self.program.texts)
        self._reply(replies)

    def _report(self):
        text, self.program.open = self.program.open[0], None
        if self.rng.random() < 0.3:
            self.program.refused.add(text)
            self._reply(self.board.report(REFUSES))
        else:
            self._reply(self.board.report(DONE))

    def _reply(self, frames):
        self.to_computer.send(b"".join(encode(frame, self.board.session) for frame in frames), self.now)

    def _take(self):
        session = self.computer.session
        for text, outcome in session.outcomes:
            if text in self.outcomes:
                raise Failure(f"{text}: two outcomes, {self.outcomes[text]} and {outcome}")
            self.outcomes[text], self.news_at = outcome, self.now
            self._check(text, outcome)
        for request, texts in session.answers:
            if texts is None:
                continue
            self.believed += 1
            if texts not in self.program.said.get((self.nonce, request), []):
                raise Failure(f"answer {request} is believed to be {texts}")
        session.outcomes, session.answers, session.pages = [], [], []

    def _check(self, text, outcome):
        carried, refused = text in self.program.carried_out, text in self.program.refused
        if outcome == window.DONE and (refused or not carried):
            raise Failure(f"{text} is reported done, and was {'refused' if refused else 'not carried out'}")
        if outcome == window.REFUSED and not refused:
            raise Failure(f"{text} is reported refused, and was not")
        if outcome == NOT_SENT and carried:
            raise Failure(f"{text} was not sent, and is carried out")

    def _check_order(self):
        numbers = [int(text[2:-1]) for text in self.program.carried_out]
        for first, second in zip(numbers, numbers[1:]):
            if first >= second:
                raise Failure(f"c({second}) is carried out after c({first})")


DEFECTS = [
    ("the checksum is not looked at", patch("javino2.frames.crc16", lambda data, nonce=0: 0)),
    ("the board goes on behind a refusal", patch.object(Board, "_is_next", lambda self, n: n == self.due and not self.busy)),
    ("the board carries out what is repeated", patch.object(Board, "_is_next", lambda self, n: not self.refused and not self.busy)),
    ("HELLO that comes twice begins anew", mutations.replaced(Board, "receive", mutations.begins_anew)),
    ("frames are the same in all sessions", patch("javino2.frames.begins_sessions", lambda kind: True)),
    ("FE is done when it is acknowledged", patch.object(window.Out, "as_nothing", False)),
    ("a part that is missing is not noticed", mutations.replaced(parts.Assembly, "take", mutations.any_part)),
]
# Bytes a ms; probability that a byte is damaged, that a command is refused, that its outcome is late, that an end restarts in a ms, and the
# frames that may come once more later. HELLO and its successors, if both are late, make a session once more, so only one of them is copied.
SETTINGS = [
    (11.5, 0, 0, 0, 0, nothing),
    (11.5, 1e-3, 0.02, 0, 0, nothing),
    (11.5, 1e-2, 0.3, 0, 0, nothing),
    (0.96, 1e-3, 0.1, 0.02, 0, nothing),
    (11.5, 3e-3, 0.1, 0.05, 1e-3, nothing),
    (11.5, 1e-4, 0.1, 0.05, 3e-3, has_hello),
    (11.5, 1e-4, 0.1, 0.05, 3e-3, lambda data: not has_hello(data)),
]


def run(commands, seed):
    exchanges = []
    for setting in SETTINGS:
        exchange = Exchange(random.Random(seed), *setting)
        exchange.run(commands // len(SETTINGS))
        exchanges.append(exchange)
    return exchanges


def check_defects():
    """Returns true if each defect is found."""
    missed = 0
    for name, defect in DEFECTS:
        with defect:
            try:
                for seed in range(1, 9):
                    run(14_000, seed)
                print(f"not found: {name}")
                missed += 1
            except Failure as failure:
                print(f"{name}: {failure}")
    print(f"  random exchanges: {len(DEFECTS) - missed} of {len(DEFECTS)} defects found")
    return 1 if missed else 0


def main():
    if sys.argv[1:] == ["--defects"]:
        return check_defects()
    commands = int(sys.argv[1]) if len(sys.argv) > 1 else 6000
    exchanges = run(commands, int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    for setting, exchange in zip(SETTINGS, exchanges):
        counts = {o: list(exchange.outcomes.values()).count(o) for o in (window.DONE, window.REFUSED, window.UNCONFIRMED, NOT_SENT)}
        print(f"harm {setting[1]:g}: {counts}, {exchange.believed} answers, {exchange.now / 1000:.1f} s of line time")
    print(f"  random exchanges: {commands} commands, {sum(e.believed for e in exchanges)} answers: once, in order, outcomes right")
    return 0


if __name__ == "__main__":
    sys.exit(main())
