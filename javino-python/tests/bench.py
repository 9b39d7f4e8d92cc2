#!/usr/bin/env python3
"""Measures how many requests for twelve percepts a second a board in Python answers on a pseudo-terminal. With MicroPython also
measures memory.

    tests/bench.py [PYTHON...] measures with these interpreters; python3 by default
"""
import os
import pathlib
import pty
import subprocess
import sys
import time
import tty

HERE = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(HERE.parent / "javino-arduino" / "tests" / "e2e"))
from board import Line, Session, frame1  # noqa: E402

SECONDS = 5
PROGRAM = """
import sys
sys.path.insert(0, sys.argv[1])
import javino
board = javino.Board()
count = [0]
def look():
    count[0] += 1
    for i in range(12):
        board.percept("dist", "abcdefghijkl"[i], (count[0] * 7 + i) % 200)
board.perceive(look)
board.on_action("stop", lambda: None)
try:
    board.run_forever()
except javino.LineGone:
    pass
"""


MEMORY = """
import gc, sys
sys.path.insert(0, sys.argv[1])
class Line:
    def __init__(self):
        self.arrives = b""
    def read(self):
        data, self.arrives = self.arrives, b""
        return data
    def write(self, data):
        pass
    def wait(self, ms):
        pass
def used():
    gc.collect()
    return gc.mem_alloc()
before = used()
import javino
imported = used()
from javino.frames import frame2
board, line, step = None, Line(), [100]
board = javino.Board(line)
def look():
    for i in range(12):
        board.percept("dist", "abcdefghijkl"[i], step[0] + i)
board.perceive(look)
board.on_action("stop", lambda: None)
def hear(kind, number, payload=b""):
    line.arrives = frame2(kind, number, payload, 7)
    gc.collect()
    begin = gc.mem_alloc()
    board.run()
    return gc.mem_alloc() - begin
def idle():
    begin = gc.mem_alloc()
    board.run()
    return gc.mem_alloc() - begin
hear(0x10, 7)
hear(0x20, 1, bytes(1))
print("  memory: module %d bytes, board %d" % (imported - before, used() - imported))
print("  allocated for an answer of twelve percepts %d bytes, for a command %d, for a round without bytes %d" % (
    hear(0x20, 2, b"\x0c"), hear(0x30, 0, b"\x80"), idle()))
"""


class FarEnd(Line):
    def __init__(self, fd):
        self.fd = fd
        self._begin()


def measure(name, ask):
    for _ in range(20):
        ask()
    times, end = [], time.monotonic() + SECONDS
    while time.monotonic() < end:
        begin = time.monotonic()
        ask()
        times.append(time.monotonic() - begin)
    times.sort()
    print(f"  {name}: {len(times) / SECONDS:.0f} a second; one takes {times[len(times) // 2] * 1000:.2f} ms at the median,"
          f" {times[len(times) * 99 // 100] * 1000:.2f} ms at the 99th percentile")


def main():
    script = HERE / "build" / "bench_board.py"
    script.parent.mkdir(exist_ok=True)
    script.write_text(PROGRAM)
    for python in sys.argv[1:] or ["python3"]:
        if "micro" in python:
            script.with_name("memory.py").write_text(MEMORY)
            subprocess.run([python, script.with_name("memory.py"), HERE], check=True)
        master, slave = pty.openpty()
        tty.setraw(slave)
        process = subprocess.Popen([python, script, HERE], stdin=slave, stdout=slave)
        os.close(slave)
        try:
            line = FarEnd(master)
            line.ready()
            measure(f"{os.path.basename(python)}, requests of version 1", line.ask)
            session = Session(line)
            measure(f"{os.path.basename(python)}, requests of version 2", session.ask)
            measure(f"{os.path.basename(python)}, commands of version 2", lambda: session.send(0))
        finally:
            process.kill()
            process.wait()


if __name__ == "__main__":
    main()
