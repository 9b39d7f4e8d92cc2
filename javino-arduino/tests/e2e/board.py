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
import version1  # noqa: E402
from javino2 import commands, frames, parts, percepts  # noqa: E402

frame1 = version1.frame

# Long enough for the slowest machine: it only ends what would hang.
PATIENCE = 60.0

# A machine that is busy elsewhere may halt the simulated board inside a frame; the board's own clock then halts too.
HALT_MS = 5000


class Line:
    """A serial device, read with the plain reference decoders of both versions."""

    def __init__(self, port):
        self.fd = os.open(port, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        tty.setraw(self.fd)
        self._begin()

    def _begin(self):
        self.nonce = 0  # of the session that the last HELLO has begun
        self.damage = lambda data: data
        self.listen(HALT_MS)

    def listen(self, timeout):
        """Forgets all bytes, and from now on gives a frame up after so many ms of silence."""
        self.decoder1 = version1.Decoder(timeout, frames.START)
        self.decoder2 = frames.Receiver(frames.FROM_BOARD, timeout)
        self.taken = 0

    def _take(self, data, now):
        self.decoder1.idle(now)
        for byte in data:
            # Bytes that version 1 does not take begin a frame of version 2.
            rest = bytes([byte]) if self.decoder2.body is not None else self.decoder1.put(byte)
            if rest:
                self.decoder2.nonce = self.nonce
                self.decoder2.receive(rest, now)
        self.decoder1.last = now

    def close(self):
        os.close(self.fd)

    def write(self, data):
        data = self.damage(data)
        while data:
            select.select([], [self.fd], [], PATIENCE)
            data = data[os.write(self.fd, data):]

    def send(self, frame):
        """Sends a frame of version 2, of the session that the last HELLO has begun."""
        if frame.kind == frames.HELLO:
            self.nonce = frame.number
        self.write(frames.encode(frame, self.nonce))

    def answer_bytes(self, seconds):
        """Returns the bytes of the next frame of version 1, as the board has sent them; fewer if time runs out."""
        end, data = time.monotonic() + seconds, b""
        while len(data) < 6 or len(data) < 6 + int(data[4:6], 16):
            if not select.select([self.fd], [], [], max(0.0, end - time.monotonic()))[0]:
                break
            data += os.read(self.fd, 4096)
        return data

    def _read(self, end):
        """Reads bytes until then; returns at once if any arrive."""
        ready = select.select([self.fd], [], [], max(0.0, end - time.monotonic()))[0]
        now = time.monotonic() * 1000
        if ready:
            self._take(self.damage(os.read(self.fd, 4096)), now)
        else:
            self.decoder1.idle(now)

    def messages(self, seconds=0.0):
        """Returns the texts of version 1 that arrive within this time, at once if there are any."""
        end = time.monotonic() + seconds
        while True:
            self._read(end)
            found = self.decoder1.messages[self.taken:]
            self.taken += len(found)
            if found or time.monotonic() >= end:
                return [m.decode("latin1") for m in found]

    def frames(self, seconds=0.0):
        """Returns the frames of version 2 that arrive within this time, at once if there are any."""
        end = time.monotonic() + seconds
        while True:
            self._read(end)
            if self.decoder2.frames or time.monotonic() >= end:
                found, self.decoder2.frames = self.decoder2.frames, []
                return found

    def message(self, seconds=PATIENCE):
        """Returns the next text of version 1; fails if none arrives. Puts others that arrive with it back."""
        found = self.messages(seconds)
        if not found:
            raise AssertionError(f"nothing arrived within {seconds} s")
        self.taken -= len(found) - 1
        return found[0]

    def ask(self, text="getPercepts"):
        """Sends a request of version 1 and returns its answer's text."""
        self.write(frame1(text.encode()))
        return self.message()

    def ready(self):
        """Waits until the board answers."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            self.write(frame1(b"getPercepts"))
            if self.messages(0.25):
                while self.messages(0.3):
                    pass
                return
        raise AssertionError("the board does not answer")


class FarEnd(Line):
    """The master of a pseudo-terminal in place of a device."""

    def __init__(self, fd):
        self.fd = fd
        self._begin()


class Session:
    """A session of version 2: a computer that has one command row or one request out at a time, and repeats it until it is answered."""

    def __init__(self, line, nonce=7, patience=0.25):
        self.line, self.nonce, self.patience = line, nonce, patience
        self.due, self.refused, self.busy, self.request = 0, False, False, 0
        self.repeated = 0
        self.texts = percepts.Reader()
        self.assembly = parts.Assembly()
        self.welcome = self.exchange(frames.Frame(frames.HELLO, nonce), self._welcomed).payload

    def exchange(self, frame, is_answer):
        """Sends a frame until a frame for which is_answer holds."""
        end = time.monotonic() + PATIENCE
        repeated = -1
        while time.monotonic() < end:
            self.line.send(frame)
            repeated += 1
            again = time.monotonic() + self.patience
            while time.monotonic() < again:
                for found in self.line.frames(again - time.monotonic()):
                    if is_answer(found):
                        self.repeated += repeated
                        return found
        raise AssertionError(f"no answer to {frame}")

    def _welcomed(self, frame):
        return kind_of(frame) == frames.WELCOME and frame.payload[0] == self.nonce

    def send(self, *row):
        """Sends commands, each a text, a number or a Rule. Returns how many were carried out; refused is true if the last of them was
        not."""
        first = self.due
        kind = frames.COMMANDS_RESUME if self.refused else frames.COMMANDS
        row = [c.encode("latin1") if isinstance(c, str) else c for c in row]
        self.exchange(frames.Frame(kind, first, commands.write_row(row)), lambda f: self._is_settled(f, first, len(row)))
        return (self.due - first) % 256

    def _is_settled(self, frame, first, count):
        news = (frame.number - first) % 256
        if kind_of(frame) == frames.WELCOME or news > count:
            return False
        self.due, self.refused, self.busy = frame.number, bool(frame.kind & frames.REFUSED), bool(frame.kind & frames.BUSY)
        return not self.busy and (news == count or news > 0 and self.refused)

    def ask(self, functors=""):
        """Returns the text of the percepts."""
        self.request = self.request % 255 + 1
        known = 0 if self.request == 1 else self.texts.known()
        answer = []
        self.exchange(frames.Frame(frames.ASK, self.request, bytes([known]) + functors.encode()), lambda f: self._is_answered(f, answer))
        return answer[0]

    def _is_answered(self, frame, answer):
        if not frames_of_percepts(frame):
            return False
        found = self.assembly.take(kind_of(frame), frame.payload)
        if not found or found[0] != self.request:
            return False
        texts = self.texts.read(found[1])
        if texts is not None:
            answer.append(b"".join(texts).decode("latin1"))
        return texts is not None

    def vocabulary(self):
        """Returns the board's actions as (name, arguments)."""
        found = self.exchange(frames.Frame(frames.DESCRIBE, 1, bytes([0])), lambda f: kind_of(f) == frames.VOCABULARY)
        page, actions = found.payload[3:], []
        while page:
            actions.append((page[2:2 + page[1]].decode(), page[0]))
            page = page[2 + page[1]:]
        return actions


def kind_of(frame):
    return frame.kind & ~frames.FLAGS


def frames_of_percepts(frame):
    return kind_of(frame) in (frames.PERCEPTS, frames.PART, frames.LAST_PART)


def simulator_of(board, program, *options):
    """Returns the command that runs a program on an uno, or on one of machine.py's microcontrollers."""
    if board == "uno":
        return [ROOT / "build/simulator", *options, ROOT / f"build/avr/uno/{program}.elf"]
    return [sys.executable, ROOT / "tests/e2e/machine.py", board, ROOT / f"build/{board}/{program}.elf"]


class Board:
    """A simulated board; use it in a with statement."""

    kind = "uno"

    def __init__(self, program, *options):
        self.process = subprocess.Popen(
            simulator_of(self.kind, program, *options), stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        self.buffer = b""
        self.pins = []  # (pin, state, ms) of watched pins, oldest first
        self.port = self._next_line().split()[-1]
        self.line = Line(self.port)
        self.second = Line(self._next_line().split()[-1]) if "--soft" in options else None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.line.close()
        if self.second:
            self.second.close()
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
        """Gives a command, which must be answered with ok."""
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
        """Returns the changes of watched pins since the last call."""
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
