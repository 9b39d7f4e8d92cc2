#!/usr/bin/env python3
"""Runs the POSIX example on a pseudo-terminal and talks to it: posix.py PROGRAM"""
import os
import pty
import subprocess
import sys
import tty

from board import HALT_MS, Line, reference

frame1, frame2 = reference.frame1, reference.frame2


class FarEnd(Line):
    """The master of a pseudo-terminal in place of a device."""

    def __init__(self, fd):
        self.fd = fd
        self.decoder = reference.Decoder(timeout=HALT_MS)
        self.taken = 0
        self.damage = lambda data: data


def equal(found, expected):
    if found != expected:
        raise AssertionError(f"found {found!r}, expected {expected!r}")


def talk(line, program):
    line.ready()
    line.write(frame1(b"dim(30)"))
    equal(program.stdout.readline(), b"lamp 30\n")
    equal(line.ask().split(";")[0], "lamp(30)")
    line.write(frame2(b"lampOn", 2, 5))
    answer = line.message()
    equal((answer.flags, answer.sequence), (4, 5))
    equal(program.stdout.readline(), b"lamp 100\n")
    for refused in (b"dim(101)", b"dim(x)", b"dim", b"dim()", b"fly", b""):
        line.write(frame2(refused, 2, 6))
        equal(line.message().flags, 8)
    line.write(frame2(b"getPercepts(lamp)", 0, 7))
    equal(line.message().text, "lamp(100);")
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
