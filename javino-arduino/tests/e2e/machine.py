#!/usr/bin/env python3
"""A program on a microcontroller under QEMU: machine.py MACHINE PROGRAM

It is used like build/simulator: prints "port PATH" of a pseudo-terminal that is the board's line, takes commands for pins on standard
input and ends with it. Bytes to the board take the time that 115200 baud gives them.
"""
import ctypes
import os
import pty
import select
import signal
import socket
import subprocess
import sys
import time
import tty

MACHINES = {
    "cortex-m": ["qemu-system-arm", "-M", "mps2-an385"],
    "coldfire": ["qemu-system-m68k", "-M", "mcf5208evb"],
    "mips": ["qemu-system-mipsel", "-M", "malta", "-cpu", "24Kf", "-vga", "none", "-nic", "none"],
    "riscv": ["qemu-system-riscv32", "-M", "sifive_e"],
}

BYTES_AT_ONCE = 12
BYTE_SECONDS = 10 / 115200
PR_SET_PDEATHSIG = 1


def die_with_parent():
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def run_machine(machine, program):
    """QEMU, and the far ends of its first two serial ports."""
    pairs = [socket.socketpair() for _ in range(2)]
    command = [*MACHINES[machine], "-kernel", program, "-display", "none", "-monitor", "none"]
    for i, (_, near) in enumerate(pairs):
        command += ["-chardev", f"socket,id=port{i},fd={near.fileno()}", "-serial", f"chardev:port{i}"]
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, preexec_fn=die_with_parent, pass_fds=[n.fileno() for _, n in pairs])
    for _, near in pairs:
        near.close()
    return process, [far for far, _ in pairs]


class Pacer:
    """Hands bytes on at the pace of the line."""

    def __init__(self, to):
        self.to, self.waiting, self.free = to, b"", 0.0

    def delay(self):
        """Returns the seconds until the next bytes are due; None: none are."""
        return max(0.0, self.free - time.monotonic()) if self.waiting else None

    def move(self):
        now = time.monotonic()
        if self.waiting and now >= self.free:
            part, self.waiting = self.waiting[:BYTES_AT_ONCE], self.waiting[BYTES_AT_ONCE:]
            self.to.sendall(part)
            self.free = now + len(part) * BYTE_SECONDS


def relay(process, line, panel):
    master, slave = pty.openpty()  # the slave stays open, so that the line may be closed and opened
    tty.setraw(slave)
    print(f"port {os.ttyname(slave)}", flush=True)
    pacer = Pacer(line)
    while process.poll() is None:
        ready = select.select([0, master, line, panel], [], [], pacer.delay())[0]
        if 0 in ready:
            commands = os.read(0, 4096)
            if not commands:
                return
            panel.sendall(commands)
        if master in ready:
            pacer.waiting += os.read(master, 4096)
        if line in ready:
            os.write(master, line.recv(4096))
        if panel in ready:
            os.write(1, panel.recv(4096))
        pacer.move()
    sys.exit(f"QEMU has ended with status {process.returncode}")


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in MACHINES:
        sys.exit(f"usage: machine.py {'|'.join(MACHINES)} PROGRAM")
    process, (line, panel) = run_machine(*sys.argv[1:])
    try:
        relay(process, line, panel)
    finally:
        process.kill()
        process.wait()


if __name__ == "__main__":
    main()
