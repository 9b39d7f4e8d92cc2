#!/usr/bin/env python3
"""Gives a board on the C core and the reference the same random streams, and tells the first difference.

    differential.py [--streams N] [--seed S] PROGRAM...      PROGRAM is driven/board.c, compiled, and its arguments
"""
import argparse
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "vectors"))
import version1  # noqa: E402
from driven import answers, record  # noqa: E402
from javino2 import commands, frames  # noqa: E402
from javino2.board import DONE, LATER, REFUSES  # noqa: E402
from javino2.device import Device  # noqa: E402
from javino2.program import Program  # noqa: E402


RULES_SIZE = 250


class Knows(Program):
    """The program of driven/board.c."""

    def __init__(self):
        super().__init__([(b"front", 0), (b"left", 0), (b"speed", 1), (b"bump", 0), (b"grip", 0), (b"say", 255)])

    def carry_out(self, text):
        if text not in (b"front", b"left", b"grip", b"say") and not (text.startswith(b"speed(") and len(text) > 6):
            return REFUSES
        self.carried_out.append(text)
        return LATER if text == b"grip" else DONE


class AnyOrder(list):
    """Frames whose order is free."""

    def __eq__(self, sent):
        for frame in self:
            if frame not in sent:
                return False
            sent = sent.replace(frame, b"", 1)
        return not sent

    def hex(self):
        return " ".join(frame.hex() for frame in self)


class Stream:
    """One random conversation with the reference. Mostly sends what it expects next."""

    TEXTS = [b"front", b"left", b"speed(5)", b"speed(fffe05front)", b"bump", b"grip", b"fly", b"say", b"speed(\"\xa4\xa5\xff\")"]

    def __init__(self, rng):
        self.rng = rng
        self.now = rng.randrange(70000)
        self.has_rules = rng.random() < 0.4
        self.device = Device(Knows(), self.now, credit=63, max_rules=8 if self.has_rules else 0, shapes=64)
        self.request = 0
        self.steps = []  # each as its name, its record, and the reference's answer

    def run(self):
        self._step("new", record(b"n", self.now, flag=RULES_SIZE if self.has_rules else 0), b"")
        self._step("begin", record(b"b", self.now), self.device.receive(b"", self.now))
        if self.has_rules:
            hello = frames.encode(frames.Frame(frames.HELLO, 7))
            self._step("hello", record(b"b", self.now, hello), self.device.receive(hello, self.now))
        for _ in range(self.rng.randrange(2, 14)):
            kind = self.rng.random()
            if self.has_rules and kind < 0.4:
                self._percepts()
                self._look()
            elif kind < 0.1:
                self._percepts()
            elif kind < 0.2:
                self._outcome()
            elif kind < 0.25 and not self.has_rules and self.device.board.session and self.device.program.texts:
                self._step("unasked", record(b"u", self.now), self.device.percepts_unasked())
            else:
                self._bytes()
        self.now += 201
        self._step("end", record(b"b", self.now), self.device.receive(b"", self.now))

    def _percepts(self):
        rng = self.rng
        texts = [b"p%d(%s%d,%03d)" % (rng.randrange(4), rng.choice([b"", b"-", b"a,"]), rng.randrange(10 ** rng.randrange(1, 6)), i)
                 for i in range(rng.randrange(7))] + [b"say(\"a;b\xa5\")"] * rng.randrange(2)
        self.device.program.texts = [text + b";" for text in texts]
        self._step(f"percepts {texts}", record(b"p", self.now, b"".join(text + b"\0" for text in texts)), b"")

    def _look(self):
        """The board may tell of the rules that begin to be met in any order."""
        self.now += 5
        frames_sent = [frames.encode(frame, self.device.board.session) for frame in self.device.board.look()]
        self._step(f"a look at {self.now}", record(b"l", self.now), AnyOrder(frames_sent))

    def _outcome(self):
        done = self.rng.random() < 0.5
        self._step(f"outcome {done}", record(b"d", self.now, flag=done), self.device.report(DONE if done else REFUSES))

    def _bytes(self):
        data = b"".join(self._harm(self._message()) for _ in range(self.rng.choice((1, 1, 1, 2, 3))))
        cut = self.rng.randrange(len(data) + 1) if self.rng.random() < 0.3 else len(data)
        for piece in (data[:cut], data[cut:]):
            if piece:
                self.now += self.rng.choice((0, 0, 0, 3, 10, 40, 40, 90, 150, 300))
                self._step(f"at {self.now} {piece.hex()}", record(b"b", self.now, piece), self.device.receive(piece, self.now))

    def _message(self):
        rng = self.rng
        if self.has_rules and rng.random() < 0.7:
            return self._sealed(frames.Frame(frames.COMMANDS_RESUME, self.device.board.due, self._row()))
        kind = rng.random()
        if kind < 0.12:
            return self._sealed(frames.Frame(frames.HELLO, rng.choice((0, *[rng.randrange(1, 256)] * 9, *[self.device.board.session] * 6))))
        if kind < 0.25:
            self.request = self.request % 255 + 1
            known = rng.choice((0, 0, rng.randrange(4), len(self.device.board.writer.ids), 255))
            functors = rng.choice((b"", b"", b"(p0,p2)", b"(say)"))
            return self._sealed(frames.Frame(frames.ASK, self.request, rng.choice((bytes([known]) + functors, b""))))
        if kind < 0.3:
            return self._sealed(frames.Frame(frames.DESCRIBE, rng.randrange(1, 256), bytes([rng.randrange(8)])))
        if kind < 0.4:
            return version1.frame(rng.choice((b"getPercepts", b"getPercepts(p1)", b"front", b"speed(\xa5\xa4)", b"fly", b"")))
        if kind < 0.45:
            return rng.randbytes(rng.randrange(12))
        if kind < 0.5:
            return self._sealed(frames.Frame(rng.randrange(256), rng.randrange(256), rng.randbytes(rng.randrange(6))))
        row = self._row()
        due = self.device.board.due + rng.choice((0, 0, 0, 0, -1, 1, -2, 100, 128, 130))
        return self._sealed(frames.Frame(rng.choice((frames.COMMANDS, frames.COMMANDS_RESUME)), due & 255, row))

    def _sealed(self, frame):
        """The bytes of a frame, mostly in the session of now."""
        return frames.encode(frame, self.rng.choice((*[self.device.board.session] * 15, self.rng.randrange(256))))

    def _row(self):
        rng = self.rng
        row = b""
        for _ in range(rng.randrange(6)):
            if self.has_rules and rng.random() < 0.6:
                row += commands.item(commands.Rule(self._rule()))
            else:
                row += commands.item(rng.choice((commands.NOTHING, rng.randrange(8), 0, 1, rng.choice(self.TEXTS))))
        if rng.random() < 0.1:
            row += rng.choice((b"\xff\x80", b"\xff\x00", b"\xff", b"\xff\x03\x07a\x00", b"\xff\x01\x00", b"\x00", b"\x05abc", b"\x00\x90abc", b"\x00\x00\x80", b"\x00\x05front", b"\x81", b"\xfd"))
        return row

    def _rule(self):
        """Mostly a rule, of at most 30 bytes, so that all have room."""
        rng = self.rng
        number = bytes([rng.choice((0, *range(1, 11), 255))])
        if rng.random() < 0.15:
            return number
        text = number + b"p%d\0" % rng.randrange(4)
        for _ in range(rng.choice((0, 1, 1, 1, 2))):
            limit = rng.choice((b"5", b"-3", b"50", b"9.5", b"500", b"a", b""))
            until = rng.choice((b"", b"", b"\1" + rng.choice((b"7", b"-90", b"700", b"b", b""))))
            text += rng.choice(b"1123").to_bytes(1, "big") + rng.choice((b"<", b">", b"{", b"}", b"=", b"!", b"~")) + limit + until + b"\0"
        return text + rng.choice((b"", b"\2left", b"\2fly", b"\2"))

    def _harm(self, data):
        rng = self.rng
        kind = rng.randrange(20)
        if not data or kind > 5:
            return data
        at = rng.randrange(len(data))
        return [data[:at], data[at:], data[:at] + data[at + 1:], data[:at] + bytes([data[at]]) + data[at:],
                data[:at] + bytes([data[at] ^ 1 << rng.randrange(8)]) + data[at + 1:],
                rng.choice((b"\xa5", b"\xa4", b"f", b"fffe", b"\xa5\x01\x30")) + data][kind]

    def _step(self, what, record, sent):
        carried, self.device.program.carried_out = self.device.program.carried_out, []
        self.steps.append((what, record, (sent, carried)))

    def compare(self, found):
        for i, ((_, _, reference), core) in enumerate(zip(self.steps, found)):
            if reference != core:
                lines = [what for what, _, _ in self.steps[:i + 1]]
                lines += [f"{name} {sent.hex()} {carried}" for name, (sent, carried) in (("core     ", core), ("reference", reference))]
                raise SystemExit("a difference:\n" + "\n".join(lines))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--streams", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("program", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    streams = [Stream(random.Random(options.seed * 1_000_000 + i)) for i in range(options.streams)]
    for stream in streams:
        stream.run()
    found = answers(options.program, [record for stream in streams for _, record, _ in stream.steps])
    steps = len(found)
    for stream in streams:
        stream.compare(found[:len(stream.steps)])
        del found[:len(stream.steps)]
    print(f"  core against reference: {options.streams} random streams, {steps} steps, no difference")
    return 0


if __name__ == "__main__":
    sys.exit(main())
