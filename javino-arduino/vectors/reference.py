#!/usr/bin/env python3
"""Checks the vectors of both versions of the protocol against the reference.

    reference.py            report differences
    reference.py --write    write javino2-vectors.json

The reference is written from docs/protocol.md, as plainly as possible: version1.py for version 1, and javino2/ for version 2. It is a
second opinion on the vectors, the C core and the Java link. The vectors of version 1 are written by hand. The reference computes the
vectors of version 2 from the inputs in cases2.py.
"""
import json
import pathlib
import sys

import cases2
import version1
from javino2.frames import crc16

HERE = pathlib.Path(__file__).parent


def check1(vectors):
    """Returns a text for each disagreement with the vectors of version 1."""
    wrong = []

    def expect(name, what, found, expected):
        if found != expected:
            wrong.append(f"{name}: {what} should be {expected}, the reference has {found}")

    for case in vectors["crc"]:
        expect(case["name"], "the CRC", "%04X" % crc16(bytes.fromhex(case["hex"])), case["crc"])
    for case in vectors["encode"]:
        expect(case["name"], "the frame", version1.frame(bytes.fromhex(case["hex"])).hex(), case["frame"])
    for case in vectors["decode"]:
        decoder, now = version1.Decoder(case["timeoutMs"]), 0
        for chunk in case["chunks"]:
            now += chunk["gapMs"]
            decoder.receive(bytes.fromhex(chunk["hex"]), now)
            if "delivered" in chunk:
                expect(case["name"], "messages delivered after a chunk", len(decoder.messages), chunk["delivered"])
        decoder.idle(now + case["endGapMs"])
        expect(case["name"], "the messages", [m.hex() for m in decoder.messages], case["messages"])
    return wrong


def check2(vectors):
    """Returns a text for each disagreement with the vectors of version 2."""
    made, wrong = cases2.vectors(), []
    for group in made.keys() | vectors.keys():
        expected, found = vectors.get(group, []), made.get(group, [])
        wrong += [f"{group}: {e['name'] if isinstance(e, dict) else e}: the reference has {f}" for e, f in zip(expected, found) if e != f]
        if len(expected) != len(found):
            wrong.append(f"{group}: {len(expected)} cases, the reference has {len(found)}")
    return wrong


def compact(vectors):
    """Returns the vectors as JSON, one case a line."""
    groups = []
    for name, cases in vectors.items():
        groups.append(f"  {json.dumps(name)}: [\n" + ",\n".join("    " + json.dumps(c) for c in cases) + "\n  ]")
    return "{\n" + ",\n".join(groups) + "\n}\n"


def main():
    path2 = HERE / "javino2-vectors.json"
    if sys.argv[1:] == ["--write"]:
        path2.write_text(compact(cases2.vectors()))
    vectors1, vectors2 = json.loads((HERE / "javino-vectors.json").read_text()), json.loads(path2.read_text())
    wrong = check1(vectors1) + check2(vectors2)
    for line in wrong:
        print(line)
    cases = sum(len(group) for vectors in (vectors1, vectors2) for name, group in vectors.items() if name != "about")
    print(f"{cases} cases, {len(wrong)} disagreements")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
