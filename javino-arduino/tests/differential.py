#!/usr/bin/env python3
"""Feeds random streams to the C decoder and to the plain reference and stops at the first difference.

    differential.py LIBRARY [STREAMS]

LIBRARY is the core as a shared library.
"""
import ctypes
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "vectors"))
import reference  # noqa: E402


class Frame(ctypes.Structure):
    _fields_ = [("payload", ctypes.POINTER(ctypes.c_uint8)), ("crc", ctypes.c_uint16), ("length", ctypes.c_uint8),
                ("version", ctypes.c_uint8), ("control", ctypes.c_uint8), ("clean", ctypes.c_bool)]


class CDecoder:
    """The C core's decoder behind the reference's interface."""

    WINDOW = 273

    def __init__(self, library):
        self.library = library
        self.state = ctypes.create_string_buffer(256)
        self.bytes = (ctypes.c_uint8 * self.WINDOW)()
        self.messages = []
        library.javino_decoder_init(self.state, self.bytes, self.WINDOW, 100)

    def idle(self, now):
        frame = Frame()
        while self.library.javino_decoder_next(self.state, now & 0xFFFF, ctypes.byref(frame)):
            message = {"version": frame.version}
            if frame.version == 2:
                message.update(flags=frame.control >> 4, sequence=frame.control & 15)
            message["hex"] = bytes(frame.payload[:frame.length]).hex()
            self.messages.append(message)

    def receive(self, data, now):
        self.idle(now)
        for byte in data:
            if not self.library.javino_decoder_ready(self.state):
                raise AssertionError("no room")
            self.library.javino_decoder_put(self.state, byte, now & 0xFFFF)
            self.idle(now)


def stream(rng):
    """Chunks of (gap in ms, bytes): frames, pieces of frames, damage and noise."""
    chunks = []
    for _ in range(rng.randrange(1, 9)):
        payload = bytes(rng.choice(b"fffffeeedd0012345aAF;x") for _ in range(rng.randrange(rng.choice((4, 12, 60)))))
        if rng.random() < 0.3:
            payload = payload + reference.frame1(payload[:20]) + payload[:3]
        data = reference.frame1(payload) if rng.random() < 0.5 else reference.frame2(payload, rng.randrange(16), rng.randrange(16))
        kind = rng.randrange(6)
        at = rng.randrange(len(data))
        if kind == 0:
            data = data[:at]
        elif kind == 1:
            data = data[:at] + bytes([rng.randrange(256)]) + data[at + 1:]
        elif kind == 2:
            data = data[:at] + data[at + 1:]
        elif kind == 3:
            data = bytes(rng.choice(b"fed05") for _ in range(rng.randrange(8))) + data
        cut = rng.randrange(len(data) + 1)
        chunks += [(rng.choice((0, 0, 0, 40, 150)), data[:cut]), (rng.choice((0, 0, 0, 40, 150)), data[cut:])]
    return chunks


def main():
    library = ctypes.CDLL(sys.argv[1])
    library.javino_decoder_next.restype = ctypes.c_bool
    library.javino_decoder_ready.restype = ctypes.c_bool
    streams = int(sys.argv[2]) if len(sys.argv) > 2 else 3000
    rng = random.Random(7)
    delivered = 0
    for _ in range(streams):
        chunks, now = stream(rng), rng.randrange(70000)
        plain, core = reference.Decoder(), CDecoder(library)
        plain.last = now
        for gap, data in chunks:
            now += gap
            plain.receive(data, now)
            core.receive(data, now)
            if not data:
                continue
            if plain.messages != core.messages:
                print("difference after", chunks, "\nreference", plain.messages, "\ncore     ", core.messages)
                return 1
        plain.idle(now + 101)
        core.idle(now + 101)
        if plain.messages != core.messages:
            print("difference in the end of", chunks, "\nreference", plain.messages, "\ncore     ", core.messages)
            return 1
        delivered += len(plain.messages)
    print(f"{streams} random streams, {delivered} messages: the core and the reference agree")
    return 0


if __name__ == "__main__":
    sys.exit(main())
