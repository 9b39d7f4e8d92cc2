#!/usr/bin/env python3
"""Compares the core in a program of its own with the vectors of frames, of checksums, of what a board receives, in both versions, and of
rules.

    driven_vectors.py PROGRAM...      PROGRAM is driven/board.c, compiled, and its arguments
"""
import json
import pathlib
import sys

VECTORS = pathlib.Path(__file__).parent.parent / "vectors"
sys.path.insert(0, str(VECTORS))
from driven import answers, record  # noqa: E402
from javino2 import commands, frames  # noqa: E402

STARTS = (0, 12345, 65400)  # the clock wraps around too


class Case:
    """Records, and what their answers are to be: a function of the answers that returns (found, expected)."""

    def __init__(self, vector, records, compared):
        self.vector, self.records, self.compared = vector, records, compared

    def check(self, found):
        found, expected = self.compared(found)
        if found != expected:
            raise SystemExit(f"{self.vector['name']}: {found} in place of {expected}")


def sends(vector, what, data, expected, flag=0):
    return Case(vector, [record(what, data=data, flag=flag)], lambda found: (found[0][0].hex(), expected.lower()))


def receives(vector, start, nonce, ends, compared):
    """A decoder that takes the chunks, and the silences behind them."""
    now, records = start, [record(b"s", flag=nonce)]
    for gap, data in [(chunk["gapMs"], bytes.fromhex(chunk["hex"])) for chunk in vector["chunks"]] + [(gap, b"") for gap in ends]:
        now += gap
        records.append(record(b"r", now, data))
    return Case(vector, records, compared)


def texts_of(found):
    return [text.hex() for _, texts in found for text in texts]


def frames_of(found):
    """The frames of version 2 that a decoder has sent, as CC SS payload."""
    frames = []
    for data, _ in found:
        while data:
            end = 3 + data[0]
            frames.append(data[1:end].hex())
            data = data[end:]
    return frames


def version_1(vectors):
    for vector in vectors["crc"]:
        yield sends(vector, b"c", bytes.fromhex(vector["hex"]), vector["crc"])
    for vector in vectors["encode"]:
        yield sends(vector, b"e", bytes.fromhex(vector["hex"]), vector["frame"])
    for vector in vectors["decode"]:
        yield from (decodes(vector, start) for start in STARTS)


def decodes(vector, start):
    messages = [m["hex"] if isinstance(m, dict) else m for m in vector["messages"]]
    counts = [(i, chunk["delivered"]) for i, chunk in enumerate(vector["chunks"]) if "delivered" in chunk]

    def compared(found):
        return (texts_of(found), [len(texts_of(found[:i + 2])) for i, _ in counts]), (messages, [count for _, count in counts])

    return receives(vector, start, 0, [vector["endGapMs"]], compared)


def version_2(vectors):
    for vector in vectors["frames"]:
        data = bytes.fromhex(vector["kind"]) + bytes([vector["number"]]) + bytes.fromhex(vector["payloadHex"])
        nonce = 0 if data[0] == 0x10 or data[0] & 0x9F == 0x80 else vector["nonce"]  # HELLO and WELCOME belong to no session
        yield sends(vector, b"E", data, vector["frameHex"], nonce)
    for vector in vectors["receive"]:
        if vector["direction"] == "to-board":
            expected = [text.encode("latin-1").hex() for text in vector["version1"]], vector["frames"]
            for start in STARTS:
                yield receives(vector, start, vector["session"], [200, 1],
                               lambda found, expected=expected: ((texts_of(found), frames_of(found)), expected))


def rules(vectors):
    return map(watches, vectors["rules"])


def watches(vector):
    """A board whose rule is set anew before each look, so that it was not met before."""
    nonce = 7
    rule = commands.item(commands.Rule(vector["command"].encode("latin-1")))

    def sets(kind, number):
        return record(b"b", data=frames.encode(frames.Frame(kind, number, rule), nonce))

    records = [record(b"n", flag=250), record(b"b", data=frames.encode(frames.Frame(frames.HELLO, nonce), 0)), sets(frames.COMMANDS, 0)]
    for i, percept in enumerate(vector["percepts"] if vector["met"] else []):
        texts = percept.encode("latin-1").removesuffix(b";") + b"\0"
        records += [sets(frames.COMMANDS_RESUME, i + 1), record(b"p", data=texts), record(b"l", 5 * (i + 1))]

    def compared(found):
        taken = frames.encode(frames.Frame(frames.ACK if vector["met"] else frames.ACK | frames.REFUSED, 1), nonce)
        return (found[2][0], [bool(sent) for sent, _ in found[5::3]]), (taken, vector["met"] or [])

    return Case(vector, records, compared)


def main():
    cases = [list(version(json.loads((VECTORS / name).read_text())))
             for version, name in ((version_1, "javino-vectors.json"), (version_2, "javino2-vectors.json"), (rules, "javino2-vectors.json"))]
    found = answers(sys.argv[1:], [r for case in sum(cases, []) for r in case.records])
    for case in sum(cases, []):
        case.check(found[:len(case.records)])
        del found[:len(case.records)]
    counts = [len({id(case.vector) for case in version}) for version in cases]
    print(f"ok   {counts[0]} vectors of version 1 and {counts[1]} of version 2, {counts[2]} of rules")


if __name__ == "__main__":
    main()
