"""Checks the test vectors of both versions, which the implementations in Java and C also check. Runs on CPython and MicroPython:
vectors.py FOLDER"""
import json
import sys

sys.path.insert(0, "/".join(sys.argv[0].split("/")[:-1] or ["."]) + "/..")
from javino import Refused, rules  # noqa: E402
from javino.board import Board, _read_row  # noqa: E402
from javino.frames import Receiver, crc16, frame1, frame2  # noqa: E402
from javino.items import Shapes  # noqa: E402
from javino.literals import to_bytes  # noqa: E402

wrong = []
compared = [0]


def expect(case, what, found, expected):
    compared[0] += 1
    if found != expected:
        wrong.append("%s: %s should be %r, found %r" % (case["name"], what, expected, found))


def unhex(text):
    return bytes([int(text[i:i + 2], 16) for i in range(0, len(text), 2)])


def to_hex(data):
    return "".join(["%02x" % byte for byte in data])


class Sink:
    def __init__(self):
        self.found1, self.found2 = [], []

    def take1(self, payload):
        self.found1.append(to_hex(payload))

    def take2(self, kind, number, payload):
        self.found2.append(to_hex(bytes((kind, number)) + payload))

    def followed(self, rightly):
        pass


def play(case, sink, receiver, end):
    now = 0
    for chunk in case["chunks"]:
        now += chunk["gapMs"]
        receiver.idle(now)
        receiver.receive(unhex(chunk["hex"]), now)
        if "delivered" in chunk:
            expect(case, "messages after a chunk", len(sink.found1), chunk["delivered"])
    receiver.idle(now + end)


def version1(vectors):
    for case in vectors["crc"]:
        expect(case, "the CRC", "%04X" % crc16(unhex(case["hex"])), case["crc"])
    for case in vectors["encode"]:
        expect(case, "the frame", to_hex(frame1(unhex(case["hex"]))), case["frame"])
    for case in vectors["decode"]:
        sink = Sink()
        play(case, sink, Receiver(sink, case["timeoutMs"]), case["endGapMs"])
        # These vectors are only for version 1, in which A5 is an ordinary byte.
        if "a5" not in "".join([chunk["hex"] for chunk in case["chunks"]]):
            expect(case, "the messages", sink.found1, case["messages"])


def frames(vectors):
    for case in vectors["frames"]:
        found = frame2(int(case["kind"], 16), case["number"], unhex(case["payloadHex"]), case["nonce"])
        expect(case, "the frame", to_hex(found), case["frameHex"])
    for case in vectors["receive"]:
        if case["direction"] != "to-board":
            continue
        sink = Sink()
        receiver = Receiver(sink)
        receiver.session = case["session"]
        play(case, sink, receiver, 200)
        expect(case, "the frames", sink.found2, case["frames"])
        expect(case, "the messages of version 1", sink.found1, [to_hex(to_bytes(text)) for text in case["version1"]])


def payloads(vectors):
    for case in vectors["commands"]:
        row = [{"rule": each[0]} if isinstance(each, tuple) else each for each in _read_row(unhex(case["payloadHex"]))]
        expect(case, "the row", row, case["commands"])
    for case in vectors["percepts"]:
        shapes = Shapes(case["shapes"])
        for answer in case["answers"]:
            found = shapes.write([to_bytes(text) for text in answer["texts"]], answer["known"])
            expect(case, "the items", to_hex(found), answer["itemsHex"])
    for case in vectors["rules"]:
        rule = case["command"]
        is_taken = rules.Rules(8).set(rule)
        expect(case, "whether it is taken", is_taken, case["met"] is not None)
        if is_taken:
            found = [rules.is_met(rules.read(rule[1:]), text) for text in case["percepts"]]
            expect(case, "what meets it", found, case["met"])


class Line:
    """The far end of a board's line: frames in, frames out."""

    def __init__(self):
        self.inbox, self.sent = b"", []

    def read(self):
        data, self.inbox = self.inbox, b""
        return data

    def write(self, data):
        self.sent.append(data)

    def wait(self, ms):
        pass

    def frames(self):
        """Returns the frames that were sent, as hex of kind, number and payload."""
        found = [frame.replace(b"\xa4\x05", b"\xa5").replace(b"\xa4\x04", b"\xa4") for frame in self.sent]
        self.sent = []
        return [to_hex(frame[2:4] + frame[4:-2]) for frame in found]


class Program:
    def __init__(self, case):
        self.now, self.nonce, self.texts, self.carried, self.later = 0, 0, [], [], 0
        self.line = Line()
        self.board = Board(self.line, ticks=lambda: self.now)
        for name, count in case["actions"]:
            self.register(name, count, name in case["refuses"], case["later"])
        self.board.perceive(self.write, *case.get("kinds", []))
        self.board.watch_rules()

    def register(self, name, count, refuses, later):
        def act(*arguments):
            if refuses:
                raise Refused
            text = name + ("(" + ",".join([str(each) for each in arguments]) + ")" if arguments else "")
            self.carried.append(text)
            if text in later:
                self.later = self.board.later()
        self.board.on_action(name, act, count)

    def write(self):
        for text in self.texts:
            self.board.add_percept(text[:-1])

    def take(self, step):
        self.carried = []
        self.texts = step.get("percepts", self.texts)
        for message in step.get("messages", []):
            self.now += 200
            self.board.run()
            self.line.inbox = frame1(to_bytes(message))
            self.board.run()
            self.nonce = 0
        self.answers = [to_hex(frame) for frame in self.line.sent if frame[:1] == b"f"]
        self.line.sent = [frame for frame in self.line.sent if frame[:1] != b"f"]
        for each in step.get("to", []):
            payload = unhex(each)
            if payload[0] == 0x10:
                self.nonce = payload[1]
            self.line.inbox = frame2(payload[0], payload[1], payload[2:], step.get("nonce", self.nonce))
            self.board.run()
        if step.get("look"):
            self.now += 5
            self.board.run()
        if "report" in step:
            self.board.done(self.later, step["report"] == "done")
        if step.get("unasked") and self.board._session:
            self.write()
            self.board.send_percepts()


def conversations(vectors):
    for case in vectors["board"]:
        program = Program(case["board"])
        for step in case["steps"]:
            if step.get("restart"):
                program = Program(case["board"])
            program.take(step)
            found, expected = program.line.frames(), step["from"]
            if step.get("look"):  # the order of several rules may differ
                found, expected = sorted(found), sorted(expected)
            # WELCOME describes the board, so only its nonce is compared.
            expect(case, "what it sends", [f[:6] if int(f[:2], 16) & 0x9F == 0x80 else f for f in found],
                   [f[:6] if int(f[:2], 16) & 0x9F == 0x80 else f for f in expected])
            expect(case, "what it carries out", program.carried, step.get("carried", []))
            expect(case, "what it answers in version 1", program.answers,
                   [to_hex(frame1(to_bytes(text))) for text in step.get("answers", [])])
    for case in vectors["vocabulary"]:
        if case["room"] != 252:
            continue
        actions = []
        for page in case["pages"]:
            actions = actions[:page["first"]] + page["actions"]
        vocabulary(case, actions)


def vocabulary(case, actions):
    names = [name for name, _ in actions]
    if len(set(names)) < len(names) or len(names) > 126:
        return  # a program has at most 126 names, all different
    program = Program({"actions": actions, "refuses": [], "later": []})
    program.take({"to": ["1007"]})
    program.line.frames()
    for page in case["pages"]:
        program.take({"to": ["28%02x%02x" % (page["request"], page["first"])]})
        expect(case, "the page", program.line.frames(), ["8600" + page["payloadHex"]])


def main():
    folder = sys.argv[1]
    with open(folder + "/javino-vectors.json") as file:
        version1(json.load(file))
    with open(folder + "/javino2-vectors.json") as file:
        vectors = json.load(file)
    for check in (frames, payloads, conversations):
        check(vectors)
    for each in wrong:
        print(each)
    print("  vectors on %s: %d comparisons, %d disagreements" % (sys.implementation.name, compared[0], len(wrong)))
    return 1 if wrong or compared[0] < 600 else 0


sys.exit(main())
