"""A sketch on the simulated board, and the far end of its line."""
import os
import pathlib
import select
import subprocess
import sys
import termios
import time
import tty

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "vectors"))
import reference  # noqa: E402

# Long enough for the slowest machine: it only ends what would hang.
PATIENCE = 20.0

# A machine that is busy elsewhere may halt the simulated board inside a frame; the board's own clock then halts too.
HALT_MS = 5000


class Line:
    """A serial device, read with the plain reference decoder."""

    def __init__(self, port):
        self.fd = os.open(port, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        tty.setraw(self.fd)
        self.decoder = reference.Decoder(timeout=HALT_MS)
        self.taken = 0
        self.damage = lambda data: data

    def close(self):
        os.close(self.fd)

    def write(self, data):
        data = self.damage(data)
        while data:
            select.select([], [self.fd], [], PATIENCE)
            data = data[os.write(self.fd, data):]

    def answer_bytes(self, seconds):
        """The bytes of the next frame of version 1, as the board has sent them; fewer if time runs out."""
        end, data = time.monotonic() + seconds, b""
        while len(data) < 6 or len(data) < 6 + int(data[4:6], 16):
            if not select.select([self.fd], [], [], max(0.0, end - time.monotonic()))[0]:
                break
            data += os.read(self.fd, 4096)
        return data

    def messages(self, seconds=0.0):
        """The messages that arrive within this time, at once if there are any."""
        end = time.monotonic() + seconds
        while True:
            ready = select.select([self.fd], [], [], max(0.0, end - time.monotonic()))[0]
            now = time.monotonic()
            if ready:
                self.decoder.receive(self.damage(os.read(self.fd, 4096)), now * 1000)
            else:
                self.decoder.idle(now * 1000)
            found = self.decoder.messages[self.taken:]
            self.taken += len(found)
            if found or now >= end:
                return [Message(m) for m in found]

    def message(self, seconds=PATIENCE):
        """The next message; fails if none arrives. Others that arrive with it are given back."""
        found = self.messages(seconds)
        if not found:
            raise AssertionError(f"nothing arrived within {seconds} s")
        self.taken -= len(found) - 1
        return found[0]

    def ask(self, text="getPercepts"):
        """A request of version 1 and its answer's text."""
        self.write(reference.frame1(text.encode()))
        return self.message().text

    def ready(self):
        """Waits until the board answers."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            self.write(reference.frame1(b"getPercepts"))
            if self.messages(0.25):
                while self.messages(0.3):
                    pass
                return
        raise AssertionError("the board does not answer")


class Message:
    def __init__(self, message):
        self.version = message["version"]
        self.flags = message.get("flags", 0)
        self.sequence = message.get("sequence", 0)
        self.text = bytes.fromhex(message["hex"]).decode("latin1")

    def __repr__(self):
        return f"version {self.version} flags {self.flags} sequence {self.sequence} {self.text!r}"


class Board:
    """A simulated board; use it in a with statement."""

    def __init__(self, sketch, *options):
        self.process = subprocess.Popen(
            [ROOT / "build/simulator", *options, ROOT / f"build/avr/uno/{sketch}.elf"],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        self.buffer = b""
        self.pins = []  # (pin, state, ms) of watched pins, oldest first
        self.port = self._next_line().split()[1]
        self.line = Line(self.port)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.line.close()
        self.process.stdin.close()
        if self.process.wait(PATIENCE) != 0:
            raise AssertionError("the simulator has failed")
        self.process.stdout.close()

    def _take_line(self):
        if b"\n" not in self.buffer:
            return None
        first, self.buffer = self.buffer.split(b"\n", 1)
        return first.decode()

    def _next_line(self, seconds=PATIENCE):
        end = time.monotonic() + seconds
        while (line := self._take_line()) is None:
            if not select.select([self.process.stdout], [], [], max(0.0, end - time.monotonic()))[0]:
                return None
            data = os.read(self.process.stdout.fileno(), 65536)
            if not data:
                raise AssertionError("the simulator has ended")
            self.buffer += data
        return line

    def _note(self, line):
        words = line.split()
        self.pins.append((int(words[1]), " ".join(words[2:-1]), float(words[-1])))

    def command(self, text):
        """Gives a command that is answered with ok."""
        self.process.stdin.write(text.encode() + b"\n")
        while (line := self._next_line()) is not None:
            if line.startswith("ok"):
                return line[3:]
            if line.startswith("error"):
                raise AssertionError(line)
            self._note(line)
        raise AssertionError(f"no answer to {text}")

    def watch(self, pin):
        self.process.stdin.write(f"watch {pin}\n".encode())

    def changes(self):
        """What watched pins have done since the last call."""
        self.command("time")
        found, self.pins = self.pins, []
        return found

    def await_pin(self, pin, state):
        """Waits until a watched pin is in this state and returns the simulated time of it."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            for found in self.pins:
                if found[:2] == (pin, state):
                    seen = self.pins.index(found)
                    self.pins = [p for i, p in enumerate(self.pins) if p[0] != pin or i > seen]
                    return found[2]
            line = self._next_line(0.1)
            if line and line.startswith("pin"):
                self._note(line)
        raise AssertionError(f"pin {pin} never was {state}; it was {self.pins}")
