#!/usr/bin/env python3
"""The wire protocol written down as plainly as possible: slow, and meant to be read.

It is the second opinion on javino-vectors.json and on the C core. Run as a program, it checks every
case of the vectors file and says which ones it disagrees with.

A message is a dict as in the vectors file: {"version": 1, "hex": "6c65644f6e"}, and for version 2
"flags" and "sequence" besides.
"""
import json
import pathlib
import sys

PREAMBLES = {1: b"fffe", 2: b"fffd"}
HEX = b"0123456789abcdefABCDEF"


def crc16(data):
    """CRC-16/CCITT-FALSE of the bytes."""
    crc = 0xFFFF
    for byte in data:
        crc ^= byte << 8
        for _ in range(8):
            crc = (crc << 1) ^ (0x1021 if crc & 0x8000 else 0)
            crc &= 0xFFFF
    return crc


def frame1(payload):
    """A version 1 frame around at most 255 bytes."""
    return b"fffe%02X" % len(payload) + payload


def frame2(payload, flags, sequence):
    """A version 2 frame around at most 255 bytes."""
    body = b"%02X%X%X" % (len(payload), flags, sequence) + payload
    return b"fffd" + body + b"%04X" % crc16(body)


def fragments(payload, sequence):
    """The frames of one version 2 message of any length; the first carries this sequence number."""
    pieces = [payload[i:i + 255] for i in range(0, len(payload), 255)] or [b""]
    last = len(pieces) - 1
    return [frame2(p, 1 if i < last else 0, (sequence + i) % 16) for i, p in enumerate(pieces)]


class Decoder:
    """A receiver by the protocol's rules. Time is in milliseconds and only ever passed in."""

    def __init__(self, versions=(1, 2), timeout=100):
        self.versions = versions
        self.timeout = timeout
        self.window = b""
        self.delivered = 0  # bytes at the window's start that are a frame which has been delivered
        self.last = 0
        self.messages = []

    def receive(self, data, now):
        """Takes bytes that arrive together."""
        self.idle(now)
        for byte in data:
            self.window += bytes([byte])
            self._parse()
        self.last = now

    def idle(self, now):
        """Says that it is this late and that nothing else has arrived."""
        if now - self.last <= self.timeout:
            return
        while self.window:
            if self.delivered == len(self.window):
                self._drop(self.delivered)
            elif self.delivered and self._header(self.window[self.delivered:]) == "yes":
                self._drop(self.delivered)
            else:
                self._drop(1)
            self._parse()

    def _drop(self, count):
        self.window = self.window[count:]
        self.delivered = 0

    def _parse(self):
        while self.window:
            if self.delivered:
                follows = self._header(self.window[self.delivered:])
                if follows == "maybe":
                    return
                self._drop(self.delivered if follows == "yes" else 1)
                continue
            message, length = self._frame()
            if message == "incomplete":
                return
            if message is None:
                self._drop(1)
                continue
            self.messages.append(message)
            self.delivered = length

    def _version(self, data):
        for version in self.versions:
            if PREAMBLES[version].startswith(data[:4]):
                return version if len(data) >= 4 else 0
        return None

    def _header(self, data):
        """Whether a preamble and two hex digits stand here: yes, no or maybe (too few bytes to know)."""
        if self._version(data) is None or any(c not in HEX for c in data[4:6]):
            return "no"
        return "yes" if len(data) >= 6 else "maybe"

    def _frame(self):
        header = self._header(self.window)
        if header == "no":
            return None, 0
        if header == "maybe":
            return "incomplete", 0
        size = int(self.window[4:6], 16)
        if self._version(self.window) == 1:
            if len(self.window) < 6 + size:
                return "incomplete", 0
            return {"version": 1, "hex": self.window[6:6 + size].hex()}, 6 + size
        digits = self.window[8 + size:12 + size]
        if any(c not in HEX for c in self.window[6:8]):
            return None, 0
        if not (b"%04X" % crc16(self.window[4:8 + size])).startswith(digits.upper()):
            return None, 0
        if len(digits) < 4:
            return "incomplete", 0
        message = {"version": 2, "flags": int(self.window[6:7], 16), "sequence": int(self.window[7:8], 16),
                   "hex": self.window[8:8 + size].hex()}
        return message, 12 + size


def check(vectors):
    """The disagreements with a vectors file, one text each."""
    wrong = []

    def expect(name, what, found, expected):
        if found != expected:
            wrong.append(f"{name}: {what} should be {expected}, the reference has {found}")

    for case in vectors["crc"]:
        expect(case["name"], "the CRC", "%04X" % crc16(bytes.fromhex(case["hex"])), case["crc"])
    for case in vectors["encode"]:
        payload = bytes.fromhex(case["hex"])
        frame = frame1(payload) if case["version"] == 1 else frame2(payload, case["flags"], case["sequence"])
        expect(case["name"], "the frame", frame.hex(), case["frame"])
    for case in vectors["fragment"]:
        frames = [f.hex() for f in fragments(bytes.fromhex(case["hex"]), case["sequence"])]
        expect(case["name"], "the frames", frames, case["frames"])
    for case in vectors["decode"]:
        for versions in case["receivers"]:
            name = f"{case['name']} (receiver of versions {versions})"
            decoder, now = Decoder(versions, case["timeoutMs"]), 0
            for chunk in case["chunks"]:
                now += chunk["gapMs"]
                decoder.receive(bytes.fromhex(chunk["hex"]), now)
                if "delivered" in chunk:
                    expect(name, "messages delivered after a chunk", len(decoder.messages), chunk["delivered"])
            decoder.idle(now + case["endGapMs"])
            expect(name, "the messages", decoder.messages, case["messages"])
    return wrong


def main():
    path = pathlib.Path(__file__).with_name("javino-vectors.json")
    vectors = json.loads(path.read_text())
    wrong = check(vectors)
    for line in wrong:
        print(line)
    cases = sum(len(vectors[kind]) for kind in ("crc", "encode", "fragment", "decode"))
    print(f"{cases} cases, {len(wrong)} disagreements")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
