"""Frames of the Javino protocol, versions 1 and 2. This module finds frames in received bytes, and makes frames.

The module uses no line and no clock: the caller passes in bytes, and times in milliseconds.
"""
try:
    from binascii import crc_hqx  # this CRC in C
except ImportError:  # on microcontrollers
    crc_hqx = None

START = 0xA5
ESCAPE = 0xA4

HELLO = 0x10
ASK = 0x20
DESCRIBE = 0x28
COMMANDS = 0x30
RESUME = 0x31
WELCOME = 0x80
ACK = 0x81
PERCEPTS = 0x82
PART = 0x83
LAST_PART = 0x84
CRITICAL = 0x85
VOCABULARY = 0x86
REFUSED = 0x40
BUSY = 0x20

REVISION = 1
"""This implementation's revision of version 2, for WELCOME."""

MAX_PAYLOAD = 255
"""The largest payload of a frame in bytes, in both versions."""

_TO_BOARD = (HELLO, ASK, DESCRIBE, COMMANDS, RESUME)
_PREAMBLE = b"fffe"
_HEADER = 6
_IDLE_MS = 100
_HEX = b"0123456789abcdefABCDEF"
_NO, _MAYBE, _YES = 0, 1, 2


def crc16(data, nonce=0):
    """Returns the CRC-16/CCITT-FALSE of the bytes. With a nonce, returns the checksum of a frame in that session."""
    crc = 0xFFFF ^ nonce << 8
    if crc_hqx:
        return crc_hqx(data, crc)
    for byte in data:
        # Divides a whole byte by the polynomial 1021 in one step.
        x = (crc >> 8) ^ byte
        x ^= x >> 4
        crc = ((crc << 8) ^ (x << 12) ^ (x << 5) ^ x) & 0xFFFF
    return crc


def frame1(payload):
    """Returns a frame of version 1 with this payload of at most 255 bytes."""
    return _PREAMBLE + b"%02X" % len(payload) + payload


def frame2(kind, number, payload, nonce):
    """Returns a frame of version 2 in the session with this nonce, with escapes. The payload has at most 255 bytes."""
    body = bytes((len(payload), kind, number)) + payload
    crc = crc16(body, 0 if kind == HELLO or kind & ~(REFUSED | BUSY) == WELCOME else nonce)
    body += bytes((crc >> 8, crc & 255))
    return b"\xa5" + body.replace(b"\xa4", b"\xa4\x04").replace(b"\xa5", b"\xa4\x05")


def _header(data, at, end):
    """Returns _YES if a preamble and two hex digits are at this index, _NO if not, _MAYBE if there are too few bytes."""
    for i in range(min(_HEADER, end - at)):
        byte = data[at + i]
        if byte != _PREAMBLE[i] if i < 4 else byte not in _HEX:
            return _NO
    return _YES if end - at >= _HEADER else _MAYBE


def idle_ms(baud=None):
    """Returns the milliseconds of silence that end an unfinished frame: 100, or 20 byte times at this rate if they take longer."""
    return max(_IDLE_MS, 200000 // baud) if baud else _IDLE_MS


class Receiver:
    """Finds the frames for a board, on a line with frames of both versions.

    `sink` has three methods. `take1(payload)` and `take2(kind, number, payload)` are called after the last byte of a frame.
    `followed(rightly)` tells whether the bytes after a frame of version 1 show that it was read correctly.
    """

    def __init__(self, sink, timeout=_IDLE_MS, longest=MAX_PAYLOAD):
        self.session = 0
        """The nonce of the board's session; 0 without a session. The sink sets it, in `take1` and `take2`."""
        self._sink = sink
        self._timeout = timeout
        self._longest = longest
        self._last = None  # time at which bytes last came
        self._body = None  # the unescaped bytes of the version 2 frame being read
        self._escaped = False
        self._window = b""  # bytes that may belong to a frame of version 1
        self._held = 0  # length of the delivered frame at the window's start, or 0
        self._quiet = True  # whether a frame of version 1 may begin at the window's start

    def receive(self, data, now):
        """Takes bytes. Only `idle` notices silence, so bytes that have waited in a receive buffer do not count as late."""
        self._last = now
        self._read(data)

    def idle(self, now, diff=lambda a, b: a - b):
        """Call this with the present time if no byte is waiting. `diff` subtracts times of a clock that wraps around."""
        silence = self._timeout + 1 if self._last is None else diff(now, self._last)
        if silence > self._timeout:
            while self._window:
                self._give_up()
            self._body = None
        waits = len(self._window) > self._held
        if silence * 4 > self._timeout and not waits:
            self._quiet = True
        if silence * 16 > self._timeout and self._held and not waits:
            self._sink.followed(True)

    def is_waiting(self):
        """Returns true if a silence would drop bytes or end a frame."""
        return bool(self._window) or self._body is not None

    def _read(self, data):
        while data:
            data = self._read1(data) if self._body is None else self._read2(data)

    # ---- version 1 ----

    def _read1(self, data):
        """Reads bytes outside of frames of version 2. If a frame of version 2 begins, returns the bytes after its first byte."""
        window = self._window + data
        end = len(window)
        at = 0
        anywhere = not self.session
        while at < end:
            if window[at] == START:
                self._window = b""
                self._followed(True)
                self._begin2()
                return window[at + 1:]
            if self._held:
                behind = at + self._held
                follows = _header(window, behind, end)
                if behind < end and window[behind] == START:
                    follows = _YES
                if follows == _MAYBE:
                    break
                at = behind if follows == _YES else at + 1
                if follows == _NO:
                    self._quiet = anywhere
                self._followed(follows == _YES)
                continue
            header = _header(window, at, end) if self._quiet else _NO
            if header == _MAYBE:
                break
            if header == _NO:
                at += 1
                self._quiet = anywhere
                continue
            length = _HEADER + int(window[at + 4:at + 6], 16)
            if end - at < length:
                break
            self._held = length
            self._sink.take1(window[at + _HEADER:at + length])
            self._quiet = anywhere = not self.session
        self._window = window[at:]
        return b""

    def _followed(self, rightly):
        if self._held:
            self._held = 0
            self._sink.followed(rightly)

    def _give_up(self):
        """Handles a silence. Forgets a delivered frame, or reads an incomplete frame again from its second byte on."""
        window, held = self._window, self._held
        self._window = b""
        if held and (len(window) == held or _header(window, held, len(window)) == _YES):
            self._followed(True)
            self._read(window[held:])
        else:
            self._followed(False)
            self._quiet = not self.session
            self._read(window[1:])

    # ---- version 2 ----

    def _begin2(self):
        self._body = bytearray()
        self._escaped = False

    def _read2(self, data):
        """Continues to read a frame of version 2. Returns the bytes after the frame's end."""
        for i in range(len(data)):
            byte = data[i]
            if byte == START:
                self._begin2()
            elif self._escaped:
                self._escaped = False
                if byte not in (4, 5):
                    return self._end2(data, i)
                self._take(0xA0 | byte)
            elif byte == ESCAPE:
                self._escaped = True
            else:
                self._take(byte)
            if self._body is None:
                return self._end2(data, i)
        return b""

    def _end2(self, data, i):
        self._body = None
        self._quiet = not self.session
        return data[i + 1:]

    def _take(self, byte):
        """Takes one unescaped byte of the frame. Sets `_body` to None at the end of the frame."""
        body = self._body
        body.append(byte)
        size = len(body)
        if body[0] > self._longest or size == 2 and byte not in _TO_BOARD:
            self._body = None
        elif size == body[0] + 5:
            self._body = None
            nonce = 0 if body[1] == HELLO else self.session
            is_unchecked = body[1] != HELLO and not nonce  # without a session the board cannot check the frame, and answers WELCOME 00
            if is_unchecked or crc16(body, nonce) == 0:  # the CRC of bytes followed by their CRC is 0
                self._sink.take2(body[1], body[2], bytes(body[3:size - 2]))
