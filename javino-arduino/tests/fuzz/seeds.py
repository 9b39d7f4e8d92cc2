#!/usr/bin/env python3
"""Writes the conversations of the vectors as inputs of decoder.c, for the fuzzer to begin with: seeds.py FOLDER"""
import json
import pathlib
import sys

VECTORS = pathlib.Path(__file__).resolve().parent.parent.parent / "vectors"
sys.path.insert(0, str(VECTORS))
from javino2 import commands, frames  # noqa: E402

KINDS = [frames.HELLO, frames.ASK, frames.DESCRIBE, frames.COMMANDS, frames.COMMANDS_RESUME]
HELLO = bytes([frames.HELLO, 7])


def conversations(vectors):
    """Yields lists of frames to a board, each CC SS payload."""
    for vector in vectors["board"]:
        yield [bytes.fromhex(frame) for step in vector["steps"] for frame in step.get("to", [])]
    for vector in vectors["rules"]:
        yield [HELLO, bytes([frames.COMMANDS, 0]) + commands.item(commands.Rule(vector["command"].encode("latin-1")))]


def frame_input(frame):
    return bytes([0xFE, KINDS.index(frame[0]), frame[1], len(frame) - 2]) + frame[2:]


def main():
    vectors = json.loads((VECTORS / "javino2-vectors.json").read_text())
    for i, conversation in enumerate(conversations(vectors)):
        inputs = [frame_input(frame) for frame in conversation if frame[0] in KINDS and len(frame) < 82]
        pathlib.Path(sys.argv[1], str(i)).write_bytes(b"\xff" + b"".join(inputs))


if __name__ == "__main__":
    main()
