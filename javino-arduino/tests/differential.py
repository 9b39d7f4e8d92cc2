#!/usr/bin/env python3
"""Gives a board on the C core and the reference the same random streams, and stops at the first difference.

    differential.py BOARD [STREAMS] [SEED]

BOARD is differential_board.c, compiled. A record to it is a letter, a flag, the time in ms (2 bytes), a length (2 bytes), bytes:
`n` a new board, `b` bytes that arrive, `p` the percepts' texts, `u` they are sent unasked, `d` the outcome of the action begun last. The
answer to each has the bytes that the board has sent and the texts that it has carried out, each with a length of 4 bytes in front.
"""
import pathlib
import random
import struct
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "vectors"))
import version1  # noqa: E402
from javino2 import commands, frames  # noqa: E402
from javino2.board import DONE, LATER, REFUSES  # noqa: E402
from javino2.device import Device  # noqa: E402
from javino2.program import Program  # noqa: E402


class Knows(Program):
    """The program of differential_board.c."""

    def __init__(self):
        super().__init__([(b"front", 0), (b"left", 0), (b"speed", 1), (b"bump", 0), (b"grip", 0), (b"say", 255)])

    def carry_out(self, text):
        if text not in (b"front", b"left", b"grip", b"say") and not (text.startswith(b"speed(") and len(text) > 6):
            return REFUSES
        self.carried_out.append(text)
        return LATER if text == b"grip" else DONE


class Core:
    """The board on the C core."""

    def __init__(self, program):
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def tell(self, what, now, data=b"", flag=0):
        """(bytes sent, texts carried out)."""
        self.process.stdin.write(struct.pack("=cBHH", what, flag, now & 0xFFFF, len(data)) + data)
        self.process.stdin.flush()
        sent, carried, texts = self._field(), self._field(), []
        while carried:
            texts.append(carried[1:1 + carried[0]])
            carried = carried[1 + carried[0]:]
        return sent, texts

    def _field(self):
        length = self.process.stdout.read(4)
        if len(length) < 4:
            raise SystemExit(f"the board ended with status {self.process.wait()}")
        length = struct.unpack("=I", length)[0]
        return self.process.stdout.read(length) if length else b""


class Stream:
    """One random conversation. Mostly sends what the reference expects next."""

    TEXTS = [b"front", b"left", b"speed(5)", b"speed(fffe05front)", b"bump", b"grip", b"fly", b"say", b"speed(\"\xa4\xa5\xff\")"]

    def __init__(self, rng, core):
        self.rng, self.core = rng, core
        self.now = rng.randrange(70000)
        self.device = Device(Knows(), self.now, credit=63, max_rules=0, shapes=64)
        self.request = 0
        self.history = []

    def run(self):
        self._compare("new", self.core.tell(b"n", self.now), b"")
        self._compare("begin", self.core.tell(b"b", self.now), self.device.receive(b"", self.now))
        for _ in range(self.rng.randrange(2, 14)):
            kind = self.rng.random()
            if kind < 0.1:
                self._percepts()
            elif kind < 0.2:
                self._outcome()
            elif kind < 0.25 and self.device.board.session and self.device.program.texts:
                self._compare("unasked", self.core.tell(b"u", self.now), self.device.percepts_unasked())
            else:
                self._bytes()
        self.now += 201
        self._compare("end", self.core.tell(b"b", self.now), self.device.receive(b"", self.now))

    def _percepts(self):
        rng = self.rng
        texts = [b"p%d(%s%d,%03d)" % (rng.randrange(4), rng.choice([b"", b"-", b"a,"]), rng.randrange(10 ** rng.randrange(1, 6)), i)
                 for i in range(rng.randrange(7))] + [b"say(\"a;b\xa5\")"] * rng.randrange(2)
        self.device.program.texts = [text + b";" for text in texts]
        self._compare(f"percepts {texts}", self.core.tell(b"p", self.now, b"".join(text + b"\0" for text in texts)), b"")

    def _outcome(self):
        done = self.rng.random() < 0.5
        core = self.core.tell(b"d", self.now, flag=done)
        self._compare(f"outcome {done}", core, self.device.report(DONE if done else REFUSES))

    def _bytes(self):
        data = b"".join(self._harm(self._message()) for _ in range(self.rng.choice((1, 1, 1, 2, 3))))
        cut = self.rng.randrange(len(data) + 1) if self.rng.random() < 0.3 else len(data)
        for piece in (data[:cut], data[cut:]):
            if piece:
                self.now += self.rng.choice((0, 0, 0, 3, 10, 40, 40, 90, 150, 300))
                core = self.core.tell(b"b", self.now, piece)
                self._compare(f"at {self.now} {piece.hex()}", core, self.device.receive(piece, self.now))

    def _message(self):
        rng = self.rng
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
            row += commands.item(rng.choice((commands.NOTHING, rng.randrange(8), 0, 1, rng.choice(self.TEXTS))))
        if rng.random() < 0.1:
            row += rng.choice((b"\xff\x80", b"\xff\x00", b"\xff", b"\xff\x03\x07a\x00", b"\xff\x01\x00", b"\x00", b"\x05abc", b"\x00\x90abc", b"\x00\x00\x80", b"\x00\x05front", b"\x81", b"\xfd"))
        return row

    def _harm(self, data):
        rng = self.rng
        kind = rng.randrange(20)
        if not data or kind > 5:
            return data
        at = rng.randrange(len(data))
        return [data[:at], data[at:], data[:at] + data[at + 1:], data[:at] + bytes([data[at]]) + data[at:],
                data[:at] + bytes([data[at] ^ 1 << rng.randrange(8)]) + data[at + 1:],
                rng.choice((b"\xa5", b"\xa4", b"f", b"fffe", b"\xa5\x01\x30")) + data][kind]

    def _compare(self, what, core, reference):
        carried, self.device.program.carried_out = self.device.program.carried_out, []
        self.history.append(what)
        if core != (reference, carried):
            lines = self.history + [f"core      {core[0].hex()} {core[1]}", f"reference {reference.hex()} {carried}"]
            raise SystemExit("a difference:\n" + "\n".join(lines))


def main():
    core = Core(sys.argv[1])
    streams = int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    sent = 0
    for i in range(streams):
        stream = Stream(random.Random(seed * 1_000_000 + i), core)
        stream.run()
        sent += len(stream.history)
    print(f"  core against reference: {streams} random streams, {sent} steps, no difference")
    return 0


if __name__ == "__main__":
    sys.exit(main())
