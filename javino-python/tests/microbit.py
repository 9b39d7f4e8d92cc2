#!/usr/bin/env python3
"""Tests the module for the first micro:bit, on its MicroPython under QEMU. Prints its measurements.

    microbit.py FIRMWARE    firmware.hex of Debian's package firmware-microbit-micropython
"""
import os
import pathlib
import random
import re
import select
import socket
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "javino-arduino" / "tests" / "e2e"))
from board import PATIENCE, FarEnd, frame1  # noqa: E402
from cases import check, damage_one_in_200, equal, texts  # noqa: E402

# With the end of a line, a piece must fit into the receive buffer of 64 bytes.
PIECE = 24

FILES = ("javtext.py", "javframe.py", "javino.py")

PROGRAM = """
import gc, javino
gc.collect()
free = gc.mem_free()
board = javino.Board()
done = []
board.act["led"] = lambda: done.append("led")
board.act["ledOn"] = lambda: done.append("ledOn")
board.act["stop"] = lambda: done.append("stop")
board.on_action("speed", lambda value: done.append("speed %d" % value), 1)
board.on_action("say", lambda a, b: done.append("%s %s" % (a, b)), 2)
board.on_link_lost(400, lambda: done.append("lost"))
@board.perceive
def look():
    for text in done:
        board.percept("done", text)
    del done[:]
    board.percept("x", 1.5, True, "b", 'a "b"; c')
    board.percept("free", free)
board.run_forever(gc.collect)
"""


class MicroBit:
    def __init__(self, firmware):
        near, far = socket.socketpair()
        with far:
            self.process = subprocess.Popen(
                ["qemu-system-arm", "-M", "microbit", "-display", "none", "-monitor", "none", "-device", f"loader,file={firmware}",
                 "-chardev", f"socket,id=line,fd={far.fileno()}", "-serial", "chardev:line"],
                stdin=subprocess.DEVNULL, pass_fds=[far.fileno()])
        self.line = FarEnd(near.detach())
        self.seen = b""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.line.close()

    def until(self, end):
        """Returns the prompt's output before this text."""
        limit = time.monotonic() + PATIENCE
        while end not in self.seen:
            if not select.select([self.line.fd], [], [], max(0.0, limit - time.monotonic()))[0]:
                raise AssertionError(f"the prompt does not print {end!r} but {self.seen!r}")
            self.seen += os.read(self.line.fd, 4096)
        found, self.seen = self.seen.split(end, 1)
        return found

    def do(self, code):
        """Runs a line of code at the prompt, which does not echo."""
        self.line.write(code.encode() + b"\x04")
        self.until(b"OK")
        self.until(b"\x04")
        equal(self.until(b"\x04>"), b"")

    def copy(self, name, text):
        self.do(f"f=open({name!r},'w')")
        self.do("w=f.write")
        for at in range(0, len(text), PIECE):
            self.do(f"w({text[at:at + PIECE]!r})")
        self.do("f.close()")

    def start(self, files):
        self.until(b">>> ")
        self.line.write(b"\x01")
        self.until(b"\r\n>")
        for name, text in files:
            self.copy(name, text)
        self.line.write(b"\x02")
        self.until(b">>> ")
        self.line.write(b"\x04")
        self.until(b"soft reboot\r\n")


def done(text):
    """Returns the actions in an answer, without "lost"."""
    found = [percept[5:-1].strip('"') for percept in text.split(";") if percept.startswith("done(")]
    return [action for action in found if action != "lost"]


def exchange(board, frame=b""):
    """Sends the frame and a request, and returns the answer. Repeats the frame and the request if no answer comes: a busy machine may
    halt QEMU within a frame."""
    board.line.messages()
    for _ in range(20):
        board.line.write(frame + frame1(b"getPercepts"))
        answers = board.line.messages(1.0)
        if answers:
            return answers[0]
    raise AssertionError(f"no answer behind {frame}")


def answers_and_acts(board):
    carried = []
    for text in ("ledOn", "speed(7)", "say(\"a,b\", -1.5)", "fly", "speed", "speed(1,2)", "speed(1", "stop)", "stop(1)", "stop"):
        for action in done(exchange(board, frame1(text.encode()))):
            if action not in carried:
                carried.append(action)
    equal(carried, ["ledOn", "speed 7", "a,b -1.5", "stop"])
    check('x(1.5,true,b,"a \\"b\\"; c");' in exchange(board), "the percept is written in another way")


def notices_a_silent_computer_once(board):
    exchange(board)
    told = 0
    end = time.monotonic() + PATIENCE
    while not told and time.monotonic() < end:
        time.sleep(1)
        told = exchange(board).count("done(lost);")
    equal(told, 1)


def carries_out_no_other_action_on_a_damaged_line(board):
    rng, damaged, sent, carried, silent = random.Random(9), [0], [], [], 0
    damage, actions = damage_one_in_200(rng, damaged), texts(rng)
    while len(sent) < 300:
        text = next(actions)
        sent.append(text.split("(")[0])
        board.line.write(damage(frame1(text.encode())) + frame1(b"getPercepts"))
        answers = board.line.messages(0.3)
        silent = 0 if answers else silent + 1
        check(silent < 20, f"silent after {len(sent)} actions")
        carried += [action.split(" ")[0] for answer in answers for action in done(answer)]
    # The number may differ, because version 1 has no checksum.
    rest = iter(sent)
    check(all(action in rest for action in carried), f"carried out what was not sent: {carried} of {sent}")
    check(len(carried) > 200, f"{len(carried)} of {len(sent)} actions carried out")
    print(f"  version 1 on a micro:bit, {damaged[0]} bytes of {len(sent)} actions damaged: {len(carried)} carried out, no other one")


CASES = [answers_and_acts, notices_a_silent_computer_once, carries_out_no_other_action_on_a_damaged_line]


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: microbit.py FIRMWARE")
    failed = 0
    with MicroBit(sys.argv[1]) as board:
        board.start([(name, (HERE.parent / "microbit" / name).read_text()) for name in FILES] + [("main.py", PROGRAM)])
        board.line.ready()
        free = re.search(r"free\((\d+)\)", exchange(board)).group(1)
        print(f"  bytes that a micro:bit's MicroPython has free behind the module: {free}")
        for case in CASES:
            try:
                case(board)
                print(f"ok   {case.__name__.replace('_', ' ')}", flush=True)
            except AssertionError as failure:
                failed += 1
                print(f"FAIL {case.__name__.replace('_', ' ')}: {failure}", flush=True)
    print(f"{len(CASES)} cases, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
