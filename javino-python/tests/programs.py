#!/usr/bin/env python3
"""Runs the examples and the Python programs in the docs. A test computer greets each board, requests its description and percepts, and
sends every action. `stubs` replaces hardware, so this checks the programs' calls, not real hardware."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "stubs"), str(ROOT.parent / "javino-arduino" / "vectors")]
from javino2 import commands, frames, vocabulary  # noqa: E402

import javino  # noqa: E402
from javino import board as board_module  # noqa: E402

PAGES = [ROOT / "README.md", *sorted((ROOT.parent / "docs").glob("*.md"))]


class Computer:
    """A line whose far end sends one request after another, and then is gone."""

    name = "the test's line"

    def __init__(self):
        self.receiver = frames.Receiver(frames.FROM_BOARD)
        self.receiver.nonce = 7
        self.next = [frames.Frame(frames.HELLO, 7), frames.Frame(frames.DESCRIBE, 1, b"\0"), frames.Frame(frames.ASK, 1, b"\0")]
        self.actions = None

    def write(self, data):
        self.receiver.receive(data, 0)

    def wait(self, ms):
        pass

    def read(self):
        pages = [f for f in self.receiver.frames if f.kind & ~frames.FLAGS == frames.VOCABULARY]
        if pages and self.actions is None:
            self.actions = vocabulary.read_page(pages[0].payload)[3]
            rows = [name + (b"(%s)" % b",".join([b"1"] * count) if 0 < count < 255 else b"") for name, count in self.actions]
            self.next += [frames.Frame(frames.COMMANDS_RESUME, i, commands.write_row([row])) for i, row in enumerate(rows)]
        if not self.next:
            raise javino.LineGone("the computer has gone")
        return frames.encode(self.next.pop(0), 7)


def run(name, text):
    """Returns the percepts and the actions of the program."""
    computer = Computer()
    opened, board_module.open_line = board_module.open_line, lambda line, baud=None: computer
    argv, sys.argv = sys.argv, [name]
    try:
        exec(compile(text, name, "exec"), {"__name__": "__main__"})
        raise AssertionError(f"{name}: the program has ended by itself")
    except javino.LineGone:
        pass
    finally:
        board_module.open_line, sys.argv = opened, argv
    kinds = [frame.kind & ~frames.FLAGS for frame in computer.receiver.frames]
    for kind, what in ((frames.WELCOME, "greets"), (frames.PERCEPTS, "answers"), (frames.ACK, "acknowledges")):
        assert kind in kinds, f"{name}: the board never {what}"
    percepts = next(f.payload for f in computer.receiver.frames if f.kind & ~frames.FLAGS == frames.PERCEPTS)
    return percepts, [action[0].decode() for action in computer.actions]


def main():
    programs = {path.name: path.read_text() for path in sorted((ROOT / "examples").glob("*.py"))}
    for page in PAGES:
        for i, text in enumerate(re.findall(r"^```python\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE)):
            if "import javino" in text:
                programs[f"{page.name} {i + 1}"] = text
    for name, text in programs.items():
        _, actions = run(name, text)
        assert actions, f"{name}: the board has no actions"
        print(f"ok   {name}: {', '.join(actions)}")
    assert len(programs) >= 6, "the pages show too few programs"


if __name__ == "__main__":
    main()
