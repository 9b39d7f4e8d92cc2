"""The bytes of frames, and the receiver that finds frames among bytes."""
from typing import NamedTuple

START, ESCAPE = 0xA5, 0xA4

HELLO, ASK, DESCRIBE, COMMANDS, COMMANDS_RESUME = 0x10, 0x20, 0x28, 0x30, 0x31
WELCOME, ACK, PERCEPTS, PART, LAST_PART, CRITICAL, VOCABULARY = range(0x80, 0x87)
REFUSED, BUSY = 0x40, 0x20
FLAGS = REFUSED | BUSY

TO_BOARD, FROM_BOARD = "to-board", "from-board"


class Frame(NamedTuple):
    kind: int
    number: int
    payload: bytes = b""


def crc16(data, nonce=0):
    """Returns the CRC-16/CCITT-FALSE of the bytes. With a nonce, returns the checksum of a frame of that session."""
    crc = 0xFFFF ^ nonce << 8
    for byte in data:
        crc ^= byte << 8
        for _ in range(8):
            crc = (crc << 1) ^ (0x1021 if crc & 0x8000 else 0)
            crc &= 0xFFFF
    return crc


def escape(data):
    return data.replace(b"\xa4", b"\xa4\x04").replace(b"\xa5", b"\xa4\x05")


def begins_sessions(kind):
    """Returns true if the checksum of frames of this kind does not depend on the session."""
    return kind == HELLO or kind & ~FLAGS == WELCOME


def encode(frame, nonce=0):
    """Returns the bytes of a frame on the line, in the session with this nonce."""
    body = bytes([len(frame.payload), frame.kind, frame.number]) + frame.payload
    return bytes([START]) + escape(body + crc16(body, 0 if begins_sessions(frame.kind) else nonce).to_bytes(2, "big"))


def is_kind(direction, kind):
    if direction == TO_BOARD:
        return kind in (HELLO, ASK, DESCRIBE, COMMANDS, COMMANDS_RESUME)
    return kind & ~FLAGS in range(WELCOME, VOCABULARY + 1)


class Receiver:
    """Finds the frames of one direction, and drops all other bytes. `nonce` is the session's nonce, or 0 without a session."""

    def __init__(self, direction, timeout=100, longest=255):
        self.direction = direction
        self.timeout = timeout
        self.longest = longest
        self.nonce = 0
        self.body = None  # unescaped bytes of the frame being read, or None outside of frames
        self.escaped = False
        self.last = 0
        self.frames = []

    def receive(self, data, now):
        """Takes bytes that arrive together. Adds completed frames to `frames`."""
        if now - self.last > self.timeout:
            self.body = None
        for byte in data:
            self._put(byte)
            self.last = now

    def _put(self, byte):
        if byte == START:
            self._begin()
        elif self.body is None:
            pass
        elif self.escaped:
            self.escaped = False
            if byte in (4, 5):
                self._take(0xA0 | byte)
            else:
                self.body = None
        elif byte == ESCAPE:
            self.escaped = True
        else:
            self._take(byte)

    def _begin(self):
        self.body, self.escaped = b"", False

    def _take(self, byte):
        self.body += bytes([byte])
        length = self.body[0]
        if length > self.longest or len(self.body) == 2 and not is_kind(self.direction, byte):
            self.body = None
        elif len(self.body) == length + 5:
            body, crc = self.body[:-2], self.body[-2:]
            self.body = None
            if self._counts(body[1]) and self._is_intact(body, crc):
                self.frames.append(Frame(body[1], body[2], body[3:]))

    def _counts(self, kind):
        """A computer without a session accepts only WELCOME."""
        return bool(self.nonce) or self.direction == TO_BOARD or begins_sessions(kind)

    def _is_intact(self, body, crc):
        if begins_sessions(body[1]):
            return crc16(body).to_bytes(2, "big") == crc
        # A board without a session knows no nonce, so it cannot check the frame.
        return not self.nonce or crc16(body, self.nonce).to_bytes(2, "big") == crc
