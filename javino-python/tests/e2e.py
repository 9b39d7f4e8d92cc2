#!/usr/bin/env python3
"""Tests a board in Python on a pseudo-terminal, end to end. Prints its measurements.

    e2e.py PYTHON...    the interpreters: python3, micropython
"""
import os
import pathlib
import pty
import random
import select
import subprocess
import sys
import time
import tty

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "javino-arduino" / "tests" / "e2e"))
from board import PATIENCE, FarEnd, Line, Session, commands, frame1, frames, kind_of  # noqa: E402
from cases import check, damage_one_in_200, equal, texts  # noqa: E402

DAMAGED_SECONDS = 3


class Board:
    """The test's board as a process. The process uses standard input and output, or its own pseudo-terminal."""

    def __init__(self, python, own_terminal=False):
        command = [python, str(HERE / "boards" / "echo.py"), str(HERE.parent)]
        if own_terminal:
            self.process = subprocess.Popen(command + ["pty"], stderr=subprocess.PIPE, bufsize=0)
            self.buffer = b""
            self.line = Line(self.next().split()[1])
            return
        master, slave = pty.openpty()
        tty.setraw(slave)
        self.process = subprocess.Popen(command, stdin=slave, stdout=slave, stderr=subprocess.PIPE, bufsize=0)
        os.close(slave)
        self.buffer = b""
        self.line = FarEnd(master)
        if "micro" not in python:
            check(self.next().startswith("line "), "the board does not name its line")

    def __enter__(self):
        self.line.ready()
        self.session = Session(self.line, patience=0.06)
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.process.stderr.close()
        self.line.close()

    def carried(self, seconds=0.0):
        """Returns the actions carried out since the last call."""
        while select.select([self.process.stderr], [], [], seconds)[0]:
            data = os.read(self.process.stderr.fileno(), 65536)
            if not data:
                raise AssertionError("the board's program has ended: " + self.buffer.decode())
            self.buffer += data
            seconds = 0.0
        *lines, self.buffer = self.buffer.split(b"\n")
        return [line.decode() for line in lines]

    def acted(self, seconds=0.0):
        """Like carried(), but without "lost". A busy machine may halt this program for longer than the board's limit."""
        return [text for text in self.carried(seconds) if text != "lost"]

    def next(self):
        """Returns the next action that is carried out. Fails if there is none."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            found = self.acted(0.5)
            if found:
                equal(len(found), 1)
                return found[0]
        raise AssertionError("nothing was carried out")


def answers_acts_and_refuses_in_both_versions(python):
    with Board(python) as board:
        line, session = board.line, board.session
        takes = {"led": 0, "ledOn": 0, "stop": 0, "speed": 1, "say": 255, "near": 1, "grip": 1, "fail": 0}
        equal(session.vocabulary(), list(takes.items()))
        equal((session.send(1, "speed(7)", 2), session.refused), (3, False))
        equal(board.acted(1.0) + board.acted(0.05), ["ledOn", "speed(7)", "stop"])
        for refused in ("speed(0)", "speed(", "speed", "speed(1,2)", "speed()", "fly", "fail", "stop(1)", "stop)", 7, 3, 100):
            equal((session.send(refused), session.refused), (1, True))
        equal(session.ask("(count)"), "count(3);")
        for _ in range(3):
            equal(session.ask(), 'count(3);dist(f,100);text("a \\"b\\"; c",1.5,true,[1,x]);')
        for _ in range(12):  # within a session, version 1 needs a silence before it; a halted board may miss the silence
            time.sleep(0.05)
            line.write(frame1(b"ledOn"))
            carried = board.acted(5.0)
            if carried:
                break
        equal(carried, ["ledOn"])
        time.sleep(0.05)
        equal(line.ask("getPercepts(dist)"), "dist(f,100);")
        equal(board.acted(), [])


def an_outcome_is_reported_later(python):
    with Board(python) as board:
        session = board.session
        for ends, refused in (("kept", False), ("dropped", True)):
            row = commands.write_row([b"grip(%s)" % ends.encode()])
            for _ in range(2):  # as if the acknowledgement had been lost
                begun = session.exchange(frames.Frame(frames.COMMANDS_RESUME, session.due, row), is_acknowledgement)
                equal((begun.kind, begun.number), (frames.ACK | frames.BUSY, session.due))
                equal(session.ask("(dist)"), "dist(f,100);")
            session.request += 1
            closing = frames.Frame(frames.ASK, session.request, b"\0(closing)")
            ended = session.exchange(closing, lambda f: is_acknowledgement(f) and not f.kind & frames.BUSY)
            equal((ended.number, bool(ended.kind & frames.REFUSED)), (session.due + 1, refused))
            equal(board.acted(1.0), [f"grip({ends})"])
            session.due += 1


def is_acknowledgement(frame):
    return kind_of(frame) == frames.ACK


def a_reflex_is_carried_out_by_the_board_itself(python):
    with Board(python) as board:
        equal((board.session.welcome[3], board.session.send(commands.Rule(b"\x05dist\x001=f\x002<40\x00\x02stop"))), (8, 1))
        for _ in range(3):
            board.session.send("near(30)")
            equal([f.payload for f in board.line.frames(5.0) if kind_of(f) == frames.CRITICAL], [b"\x05\x01dist(f,30);"])
            equal(board.next(), "stop")
            equal(board.session.ask("(dist)"), "dist(f,30);")
            board.session.send("near(50)")
            time.sleep(0.1)
            check(len(board.session.ask()) > 30, "an answer in parts is too short")
        board.session.send(commands.Rule(b"\x00"))
        board.session.send("near(30)")
        time.sleep(0.1)
        equal(board.session.ask("(dist)"), "dist(f,30);")
        equal(board.acted(), [])


def a_silent_computer_is_noticed_once(python):
    with Board(python) as board:
        for _ in range(2):
            board.session.ask()
            check(board.carried(PATIENCE), "the silence is not noticed")
            board.carried(0.6)  # on a busy machine, the first "lost" may be for an earlier silence
            equal(board.carried(0.8), [])


def messages_of_255_bytes_go_both_ways(python):
    with Board(python) as board:
        equal(board.session.send("say(" + "x" * 248 + ")"), 1)
        equal(board.next(), "say 1 248")
        time.sleep(0.15)
        board.line.write(frame1(b"say(" + b"x" * 250 + b")"))
        equal(board.next(), "say 1 250")


def garbage_is_survived(python):
    rng = random.Random(3)
    with Board(python) as board:
        for _ in range(40):
            board.line.write(rng.choice((rng.randbytes(200), b"fffeFF" * 40, b"\xa5\xff\x30\xa4\x04" * 40, b"\xa5\x03\x30\x00\x02\xff")))
        time.sleep(0.3)
        board.line.frames()
        board.session = Session(board.line, nonce=9)
        board.carried()
        equal((board.session.send("led"), board.session.refused), (1, False))
        equal(board.next(), "led")


def version_2_carries_out_every_command_once_on_a_damaged_line(python):
    rng, damaged, expected, carried = random.Random(8), [0], [], []
    with Board(python) as board:
        actions, session = texts(rng), board.session
        board.line.listen(100)
        board.line.damage = damage_one_in_200(rng, damaged)
        end = time.monotonic() + DAMAGED_SECONDS
        while time.monotonic() < end:
            row = [next(actions) for _ in range(1 + len(expected) % 4)]
            equal((session.send(*row), session.refused), (len(row), False))
            expected += row
            if len(expected) % 5 == 0:
                equal(session.ask("(count)"), f"count({len(expected)});")
            carried += board.acted()
        carried += board.acted(0.1)
        check(len(expected) > 100 and damaged[0] > 10, f"only {len(expected)} commands and {damaged[0]} damaged bytes in the time")
        equal(carried, expected)
    print(f"  version 2 on {os.path.basename(python)}, {damaged[0]} bytes damaged in both directions: {len(expected)} commands,"
          f" frames sent again {session.repeated} times, each carried out once, in order, no other one")


def version_1_carries_out_no_other_action_on_a_damaged_line(python):
    rng, damaged, sent = random.Random(9), [0], 0
    damage = damage_one_in_200(rng, damaged)
    with Board(python) as board:
        board.line.send(frames.Frame(frames.HELLO, 0))  # ends the session
        board.line.frames(1.0)
        actions, carried = texts(rng), []
        board.carried()
        end = time.monotonic() + DAMAGED_SECONDS
        while time.monotonic() < end:
            text = next(actions)
            board.line.write(damage(frame1(text.encode())))
            sent += 1
            board.line.write(frame1(b"getPercepts(dist)"))
            board.line.messages(0.3)
            for act in board.acted():
                carried.append(act)
                # The number may differ, because version 1 has no checksum.
                equal(act.split("(")[0], text.split("(")[0])
        check(sent > 100 and damaged[0] > 5, f"only {sent} actions and {damaged[0]} damaged bytes in the time")
        check(sent - len(carried) <= 3 * damaged[0], f"{sent - len(carried)} of {sent} actions lost by {damaged[0]} damaged bytes")
    print(f"  version 1 on {os.path.basename(python)}, {damaged[0]} bytes of {sent} actions damaged: {len(carried)} carried out,"
          " none of another name")


def the_boards_own_terminal_outlives_the_computer(python):
    if "micro" in python:
        return  # a microcontroller has no pseudo-terminal
    with Board(python, own_terminal=True) as board:
        device = os.ttyname(board.line.fd)
        for nonce in range(20, 24):
            equal(board.session.ask("(dist)"), "dist(f,100);")
            board.line.close()
            time.sleep(0.05)
            board.line = Line(device)
            board.session = Session(board.line, nonce)


CASES = [
    answers_acts_and_refuses_in_both_versions,
    an_outcome_is_reported_later,
    a_reflex_is_carried_out_by_the_board_itself,
    a_silent_computer_is_noticed_once,
    messages_of_255_bytes_go_both_ways,
    garbage_is_survived,
    the_boards_own_terminal_outlives_the_computer,
    version_2_carries_out_every_command_once_on_a_damaged_line,
    version_1_carries_out_no_other_action_on_a_damaged_line,
]


def main():
    failed = 0
    for python in sys.argv[1:]:
        for case in CASES:
            name = case.__name__.replace("_", " ") + " on " + os.path.basename(python)
            try:
                case(python)
                print(f"ok   {name}", flush=True)
            except AssertionError as failure:
                failed += 1
                print(f"FAIL {name}: {failure}", flush=True)
    print(f"{len(CASES) * len(sys.argv[1:])} cases, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
