#!/usr/bin/env python3
"""Runs the POSIX example on a pseudo-terminal and talks to it: posix.py PROGRAM"""
import os
import pty
import subprocess
import sys
import tty

from board import FarEnd, Session, frame1
from cases import equal


def talk(line, program):
    line.ready()
    line.write(frame1(b"dim(30)"))
    equal(program.stdout.readline(), b"lamp 30\n")
    equal(line.ask().split(";")[0], "lamp(30)")
    session = Session(line)
    equal(session.send("lampOn"), 1)
    equal(program.stdout.readline(), b"lamp 100\n")
    equal(session.vocabulary(), [("lampOn", 0), ("lampOff", 0), ("dim", 1)])
    equal(session.send(1, "dim(7)", 0), 3)
    for lamp in (b"lamp 0\n", b"lamp 7\n", b"lamp 100\n"):
        equal(program.stdout.readline(), lamp)
    for refused in ("dim(101)", "dim(x)", "dim", "dim()", "fly"):
        session.send(refused)
        equal(session.refused, True)
    equal(session.ask("(lamp)"), "lamp(100);")
    equal(session.ask("(lamp)"), "lamp(100);")
    equal(program.stdout.readline(), b"lamp 0: nobody is there\n")


def main():
    master, slave = pty.openpty()
    tty.setraw(slave)
    program = subprocess.Popen([sys.argv[1], os.ttyname(slave)], stdout=subprocess.PIPE)
    try:
        talk(FarEnd(master), program)
    finally:
        program.kill()
        program.wait()
    print("ok   the POSIX example answers, acts, refuses and notices silence")


if __name__ == "__main__":
    main()
