#!/usr/bin/env python3
"""A board in Python for ../../javino-arduino/tests/differential.py, in place of the board in C. The test describes the commands."""
import pathlib
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
import javino  # noqa: E402
from javino.literals import to_bytes  # noqa: E402
from memory import Memory  # noqa: E402


class KnowsTexts(javino.Board):
    """Compares whole texts with action names, like the test's program."""

    def __init__(self, now, carried):
        super().__init__(Memory(), credit=63, shapes=64, ticks=lambda: now[0])
        self._carried, self.pending, self.may_look = carried, 0, False
        for name, arguments in (("front", 0), ("left", 0), ("speed", 1), ("bump", 0), ("grip", 0), ("say", javino.ANY)):
            self.on_action(name, lambda name=name: self.carry_out(name), arguments)

    def _look(self):
        """Checks the rules only when the test asks for it."""
        if self.may_look:
            super()._look()
            self.may_look = False

    def carry_out(self, text):
        if text not in ("front", "left", "grip", "say") and not (text.startswith("speed(") and len(text) > 6):
            return False
        self._carried.append(to_bytes(text))
        if text == "grip":
            self.pending = self.later() or self.pending
        return True


def main():
    now, carried, texts, board = [0], [], [], None
    high, last = 0, 0  # the test's clock has 16 bits
    while record := sys.stdin.buffer.read(6):
        what, flag, time, length = struct.unpack("<cBHH", record)
        data = sys.stdin.buffer.read(length) if length else b""
        if time < last:
            high += 65536
        last, now[0] = time, high + time
        if what == b"n":
            board, texts = KnowsTexts(now, carried), []
            if flag:
                board.watch_rules()
            board.perceive(lambda: [board.add_percept(text.decode("latin1")) for text in texts])
        elif what == b"b":
            board.run()  # notices the silence before the bytes
            board.line.arrives = data
            board.run()
        elif what == b"l":
            board.may_look = True
            board.run()
        elif what == b"p":
            texts = data.split(b"\0")[:-1]
        elif what == b"u":
            for text in texts:
                board.add_percept(text.decode("latin1"))
            board.send_percepts()
        elif what == b"d":
            board.done(board.pending, bool(flag))
        said = b"".join(bytes([len(text)]) + text for text in carried)
        carried.clear()
        for field in (board.line.sent, said):
            sys.stdout.buffer.write(struct.pack("<H", len(field)) + field)
        board.line.sent = b""


main()
