"""The cases of javino2-vectors.json. This file has the inputs. The reference computes the outputs."""
from javino2 import commands, parts, rules, vocabulary
from javino2.device import Device
from javino2.frames import FROM_BOARD, TO_BOARD, Frame, Receiver, encode
from javino2.frames import HELLO as HELLO_KIND
from javino2.line import Line
from javino2.percepts import MAX_SHAPES, Reader, Writer
from javino2.program import Program

ABOUT = [
    "Test vectors of version 2 of the Javino protocol, see docs/protocol.md. Made and checked by reference.py (make vectors).",
    "Names that end in hex hold bytes as hexadecimal digits. Texts are bytes of ISO 8859-1, a character for each byte.",
    "frames: a frame's kind (CC) and number (SS), its payload before escaping, and its bytes on the line in the session with this nonce.",
    "receive: chunks of bytes arrive gapMs after the chunk before, the bytes of a chunk at once; the timeout is 100 ms, and no gap"
    " equals it or a quarter of it. direction says who receives: to-board the board, from-board the computer. session is the nonce of its"
    " session all the time, 0 for none. frames are all that is delivered, as CC SS payload; to a board without a session they count with"
    " any checksum, HELLO excepted. For a board version1 lists the messages of version 1 that count, which is decided 200 ms after the last"
    " chunk.",
    "commands: the payload of COMMANDS and the row of commands that is read from it: the number of an action, a text, an object with the"
    " text of a rule, or null for FE."
    " Where write is true the row is written as this payload too.",
    "percepts: the answers of one session of a board with room for so many shapes: what the newest ASK says is known, the texts, the"
    " items (neighbouring ids joined). A computer that reads all answers reads the texts.",
    "void: items read one after another by one computer; texts is null where they are void, known is what the next ASK says.",
    "parts: an answer, and the payloads that carry it, as CC and payload, with so many bytes of it in each part (null: as many as a"
    " frame holds).",
    "assemble: payloads from the board, as CC and payload, and the answers that they make, each as the request's number and the items.",
    "vocabulary: pages; an action is its name and how many arguments it has, 255 for any number. numbers: what goes by number without"
    " arguments.",
    "rules: the text that sets a rule, percepts, and whether each meets it; met is null where a board refuses the text.",
    "board: conversations. A board has actions, texts that its program refuses, texts whose outcome is reported later, and the kinds of"
    " its percepts, if it describes them; all other texts are carried out. Frames are CC SS payload; of the payload of WELCOME compare"
    " the first byte only. A step has what goes to the"
    " board (to), what it sends (from) and what its program carries out (carried). Frames are those of the session that the HELLO before"
    " them began, or of that with the nonce in the step's nonce; those from the board are of its session. percepts sets the texts of now, look has the rules"
    " compared, unasked has percepts sent unasked, report gives the outcome of the action whose outcome was open, restart switches the"
    " board off and on. messages are of version 1 and go to the board before all else, each behind a silence; answers are those it sends.",
]


def text(data):
    return data.decode("latin-1")


def raw(data):
    return data.encode("latin-1")


# ---- frames ----

def frames():
    def case(name, kind, number, payload=b"", nonce=7):
        frame = Frame(kind, number, payload)
        return {"name": name, "nonce": nonce, "kind": "%02x" % kind, "number": number, "payloadHex": payload.hex(),
             "frameHex": encode(frame, nonce).hex()}

    def found(name, start, condition):
        """Returns the first of the cases whose checksum meets the condition."""
        return next(c for c in start if condition(c["frameHex"])) | {"name": name}

    def acks():
        return (case("", 0x81, n, bytes([p])) for p in range(256) for n in range(256))

    hello = case("HELLO, nonce 7, as in the page", 0x10, 7)
    assert hello["frameHex"] == "a5001007bf08"
    return [
        hello,
        case("HELLO with another nonce in use", 0x10, 7, nonce=9),
        case("WELCOME", 0x80, 0, bytes([7, 60, 255, 4, 1, 0])),
        case("WELCOME 00 with REFUSED and BUSY", 0xE0, 3, bytes([0, 60, 255, 4, 1, 0]), nonce=0),
        case("ACK in the session 1", 0x81, 10, nonce=1),
        case("ACK in the session 255", 0x81, 10, nonce=255),
        case("ASK that knows nothing", 0x20, 1, b"\x00"),
        case("ASK for functors", 0x20, 2, b"\x05(dist,light)"),
        case("DESCRIBE", 0x28, 1, b"\x00"),
        case("COMMANDS: one known action", 0x30, 0, b"\x81"),
        case("COMMANDS with RESUME", 0x31, 9, b"\x80\x0aspeed(120)"),
        case("ACK", 0x81, 10),
        case("ACK with REFUSED", 0xC1, 10),
        case("ACK with BUSY, whose kind reads A1", 0xA1, 10),
        case("PERCEPTS", 0x82, 3, b"\x01\x80\x02\x12\x3f\x95\xff"),
        case("PERCEPTS, the last part, with BUSY: the kind is A4 and escaped", 0xA4, 3, b"\x01\x00\x80"),
        case("CRITICAL with BUSY: the kind is A5 and escaped", 0xA5, 3, b"\x01\x01dist(f,3);"),
        case("PERCEPTS, the last part, with REFUSED and BUSY", 0xE4, 3, b"\x01\x00\x80"),
        case("VOCABULARY", 0x86, 0, b"\x01\x00\x01\x00\x05front"),
        case("a length of A4 is escaped", 0x30, 0, b"\x00\xa2" + b"x" * 162),
        case("a length of A5 is escaped", 0x30, 0, b"\x00\xa3" + b"x" * 163),
        case("a number of A4 is escaped", 0x30, 0xA4, b"\x80"),
        case("a number of A5 is escaped", 0x30, 0xA5, b"\x80"),
        case("A4 and A5 in the payload", 0x30, 1, b"\xa4\xa5\x04\xa4\x05\xa5\xa5"),
        found("A4 in the high byte of the checksum", acks(), lambda h: h[-6:-2] == "a404"),
        found("A5 in the high byte of the checksum", acks(), lambda h: h[-6:-2] == "a405"),
        found("A4 in the low byte of the checksum", acks(), lambda h: h[-4:] == "a404"),
        found("A5 in the low byte of the checksum", acks(), lambda h: h[-4:] == "a405"),
        case("a payload of 255 bytes, all values but 00", 0x30, 3, bytes(range(1, 256))),
        case("a payload of 255 bytes A5", 0x82, 3, b"\xa5" * 255),
        case("a frame of version 1 in a text", 0x30, 3, b"\x0bfffe05hello"),
    ]


# ---- receive ----

def receive():
    hello, row, ask = Frame(0x10, 7), Frame(0x30, 0, b"\x80\x81"), Frame(0x20, 1, b"\x00")
    def sealed(frame):
        return encode(frame, 7)

    h, r, a = sealed(hello), sealed(row), sealed(ask)
    long = sealed(Frame(0x30, 2, b"\x14say(\"fffe05hello\", 1)"))
    escaped = sealed(Frame(0x30, 0xA5, b"\x03a\xa4b"))
    ack, busy = sealed(Frame(0x81, 2)), sealed(Frame(0xA5, 2, b"\x01\x00x;"))
    welcome = sealed(Frame(0x80, 0, bytes([7, 60, 255, 4, 1, 0])))

    def case(name, direction, *chunks, session=7):
        chunks = [c if isinstance(c, tuple) else (0, c) for c in chunks]
        now, received, receiver = 1000, [], Receiver(direction)
        line = Line(received.append, now=now)
        line.session = receiver.nonce = session
        for gap, data in chunks:
            now += gap
            line.receive(data, now)
            receiver.receive(data, now)
        line.idle(now + 200)
        out = {"name": name, "direction": direction, "session": session}
        out["chunks"] = [{"gapMs": gap, "hex": data.hex()} for gap, data in chunks]
        got = [m for m in received if isinstance(m, Frame)] if direction == TO_BOARD else receiver.frames
        out["frames"] = [show(f) for f in got]
        if direction == TO_BOARD:
            out["version1"] = [text(m) for m in received if not isinstance(m, Frame)]
        return out

    def changed(data, at, value):
        return data[:at] + bytes([value]) + data[at + 1:]

    to = TO_BOARD
    v1 = b"fffe05hello"
    cases = [
        case("one frame", to, h),
        case("byte by byte", to, *[(2, bytes([b])) for b in escaped]),
        case("with gaps shorter than the timeout", to, *[(90, bytes([b])) for b in r]),
        case("three frames at once", to, h + r + a),
        case("escapes everywhere", to, escaped + encode(Frame(0x30, 0xA4, b"\xa4\xa5" * 20))),
        case("noise before, between and after frames", to, b"\x00\xff\x10\xa4\x05" + h + b"\xa4\xa4xyz" + r + b"\x07"),
        case("every flag and kind from the board", FROM_BOARD,
             *[encode(Frame(kind | flags, kind & 7, b"\x01\x02")) for kind in range(0x80, 0x87) for flags in (0, 0x20, 0x40, 0x60)]),
        case("kinds of the own direction, to a board", to, ack + h + busy + h),
        case("kinds of the own direction, to a computer", FROM_BOARD, h + ack + r + ack + a + busy),
        case("unknown kinds to a board", to, *[encode(Frame(kind, 1)) + h for kind in (0, 0x0F, 0x11, 0x21, 0x29, 0x32, 0x50, 0x70, 0x7F,
             0xFF)]),
        case("unknown kinds from a board", FROM_BOARD, *[encode(Frame(kind, 1)) + ack for kind in (0x00, 0x01, 0x41, 0x87, 0x88, 0x90, 0xC7,
             0xF1)]),
        case("an unknown kind ends the frame with that byte: what follows is noise, with frames in it", to,
             b"\xa5\x20\x7f" + h + b"abc" + r),
        case("a kind that is escaped", FROM_BOARD, encode(Frame(0xA4, 1, b"\x01\x00")) + busy),
        case("an escaped byte that is no kind", to, b"\xa5\x00\xa4\x05\x00" + h),
        case("A4 in front of another byte than 04, 05 and A5", to, r[:4] + b"\xa4\x06" + r[4:] + h),
        case("A4 in front of A5", to, r[:4] + b"\xa4" + h),
        case("A4 in front of A4", to, b"\xa5\x02\x30\x00\xa4\xa4\x05\x81" + h),
        case("A4 at the end of a chunk, 04 behind a gap", to, (0, escaped[:escaped.index(b"\xa4\x04") + 1]),
             (60, escaped[escaped.index(b"\xa4\x04") + 1:])),
        case("A4, then silence, then 04 and a frame", to, (0, b"\xa5\x01\x30\x00\xa4"), (150, b"\x04" + h)),
        case("A5 twice", to, b"\xa5" + h),
        case("A5 in front of everything, many times", to, b"\xa5\xa5\xa5" + h + b"\xa5\xa5" + r),
        case("silence inside a frame drops it", to, (0, r[:5]), (150, r[5:] + h)),
        case("silence behind each byte", to, *[(101, bytes([b])) for b in h]),
        case("silence counts from the last byte, not from the first", to, *[(60, bytes([b])) for b in r + h]),
        case("a frame that says it is longer takes in the start of the next alone", to, changed(r, 1, 9) + h + a),
        case("a frame that says it is shorter", to, changed(r, 1, 1) + h),
        case("a length of A5 that lost its escape", to, b"\xa5\xa5\x30\x00" + h),
        case("a start that is lost", to, r[1:] + h),
        case("a start that is damaged", to, b"\xa4" + r[1:] + h),
        case("a byte too many", to, r[:5] + b"\x00" + r[5:] + h),
        case("a wrong checksum", to, changed(r, len(r) - 1, r[-1] ^ 1) + h),
        case("frames of other sessions", to, encode(row, 8) + encode(ask, 135) + encode(row) + r + encode(hello, 9)),
        case("frames of other sessions, from a board", FROM_BOARD, encode(Frame(0x81, 2), 8) + encode(Frame(0x81, 2)) + welcome + ack),
        case("frames that a board without a session cannot check", to, r + encode(ask, 9) + changed(r, len(r) - 1, r[-1] ^ 1) + a,
             session=0),
        case("HELLO is checked without a session", to, changed(h, len(h) - 1, h[-1] ^ 1) + h, session=0),
        case("what is no frame is none without a session", to, r[:5], (150, r[5:] + changed(r, 1, 9)), (150, encode(Frame(0x32, 1)) + h),
             session=0),
        case("a computer without a session hears WELCOME only", FROM_BOARD, ack + busy + welcome + changed(welcome, 5, 8) + ack, session=0),
        case("the checksum's bytes exchanged", to, r[:-2] + r[:-3:-1] + h),
        case("a frame of version 1 in a text", to, long + h),
        case("a damaged frame with one of version 1 in its text is nothing, in a session", to, changed(long, 8, 1) + h),
        case("the start is damaged in front of a text with a frame of version 1, in a session", to, b"\x25" + long[1:] + h),
        case("version 1 between frames, without a session", to, h + v1, (50, v1 + h), (10, r), session=0),
        case("version 1 between frames, in a session: it counts behind a silence", to, r + v1, (50, v1), (10, r), (50, v1), (10, r),
             ),
        case("version 1 behind noise and behind another, in a session", to, (200, b"x" + v1), (200, v1 + v1), (200, b"f" + v1), (200, v1),
             ),
        case("version 1 in chunks, in a session", to, (200, v1[:3]), (60, v1[3:7]), (10, v1[7:])),
        case("version 1 cut by a silence, in a session", to, (200, v1[:8]), (150, v1[8:]), (150, v1)),
        case("A5 in the payload of version 1, without a session", to, b"fffe03a\xa5b", (200, h), session=0),
        case("A5 in the payload of version 1, in a session", to, (200, b"fffe03a\xa5b"), (200, h)),
        case("A5 in the header of version 1", to, (200, b"fffe0" + h), (200, b"ff" + h)),
        case("A5 behind a frame of version 1", to, v1 + h, session=0),
        case("version 1 to a computer", FROM_BOARD, v1 + ack + b"fffe0" + ack + v1),
    ]
    misread = {
        "a frame of version 1 that is cut takes in one of version 2, which silence shows": b"fffe20get" + h,
        "a frame of version 1 takes in one of version 2, which is shown by what follows": b"fffe09get" + h + b"xyz",
        "a frame of version 1 that is cut takes in another, which silence shows": b"fffe20get" + v1,
    }
    for session in (0, 7):
        where = "in" if session else "without"
        cases += [case(f"{what}, {where} a session", to, (200, data), session=session) for what, data in misread.items()]
    cases += [case(f"a frame cut after {i} bytes, a frame at once", to, r[:i] + h) for i in range(1, len(r))]
    cases += [case(f"a frame cut after {i} bytes, then silence, a frame", to, (0, r[:i]), (130, h)) for i in range(1, len(r))]
    cases += [case(f"byte {i} damaged", to, changed(r, i, r[i] ^ bit) + h) for i in range(len(r)) for bit in (0x01, 0x80)]
    return cases


def show(frame):
    return (bytes([frame.kind, frame.number]) + frame.payload).hex()


def read_frame(shown):
    data = bytes.fromhex(shown)
    return Frame(data[0], data[1], data[2:])


# ---- commands ----

def command_rows():
    def out(command):
        if isinstance(command, commands.Rule):
            return {"rule": text(command.text)}
        return text(command) if isinstance(command, bytes) else command

    def written(name, *row):
        payload = commands.write_row(row)
        assert commands.read_row(payload) == list(row), name
        return {"name": name, "write": True, "payloadHex": payload.hex(), "commands": [out(c) for c in row]}

    def read(name, payload):
        return {"name": name, "write": False, "payloadHex": payload.hex(), "commands": [out(c) for c in commands.read_row(payload)]}

    return [
        written("no command"),
        written("the first action", 0),
        written("the last action that has a number", 125),
        written("a text", b"speed(120)"),
        written("a text of one byte", b"x"),
        written("numbers, texts and FE", 3, b"speed(-12.5)", commands.NOTHING, 0, b"say(\"hi; you\")", commands.NOTHING),
        written("sixteen actions", *range(16)),
        written("a text of 127 bytes", b"x" * 127),
        written("a text of 128 bytes", b"x" * 128),
        written("a text of 253 bytes, the longest", b"x" * 253),
        written("a text of 128 bytes among others", 1, b"x" * 128, 2),
        written("bytes above 7F", b"say(\"\xa4\xa5\xff\")", 1),
        written("a rule", commands.Rule(b"\x07dist\x002<40\x00\x02stop")),
        written("rules among others", 1, commands.Rule(b"\x07"), b"x", commands.Rule(b"\x00"), 2),
        written("a long rule", 0, commands.Rule(b"\x07" + b"d" * 200 + b"\x00"), 1),
        written("a text that looks like a rule", b"\x07dist\x002<40\x00\x02stop"),
        read("a text that is cut", b"\x80\x05spee"),
        read("a text of which only the length is there", b"\x80\x81\x05"),
        read("a long text that is cut", b"\x82\x00\x80" + b"x" * 127),
        read("a long text of which the length is missing", b"\x82\x00"),
        read("a rule that is cut", b"\x80\xff\x05\x07dis"),
        read("a rule of which the length is missing", b"\x80\xff"),
        read("an empty rule ends the row", b"\x80\xff\x00\x81"),
        read("FE and FF in a text are bytes", b"\x02\xff\xfe\x81"),
        read("FE alone", b"\xfe"),
        read("an empty text ends the row", b"\x80\x00\x00\x81"),
        read("a short text in the long form", b"\x00\x02hi\x80"),
    ]


# ---- percepts ----

def percepts():
    def case(name, *answers, shapes=MAX_SHAPES):
        writer, reader, shown = Writer(shapes), Reader(), []
        for known, texts in answers:
            assert known <= reader.known(), name
            items = writer.write(texts, known)
            assert reader.read(items) == texts, name
            shown.append({"known": known, "texts": [text(t) for t in texts], "itemsHex": items.hex()})
        return {"name": name, "shapes": shapes, "answers": shown}

    def two(name, *texts, known=None, shapes=MAX_SHAPES):
        """Sends the texts twice. At first the computer knows no text, then as many texts as possible."""
        distinct = Writer(shapes)
        distinct.write(list(texts), 0)
        return case(name, (0, list(texts)), (len(distinct.ids) if known is None else known, list(texts)), shapes=shapes)

    page = two("the example of the page", b"dist(f,123);", b"light(f,95);")
    assert page["answers"][1]["itemsHex"] == "8002123f95ff"
    twelve = [b"dist(%c,%d);" % (c, 10 * i) for i, c in enumerate(b"abcdefghijkl")]
    full = [b"p%s(%d);" % (bytes([97 + i // 26, 97 + i % 26]), i) for i in range(127)]
    return [
        case("an empty answer", (0, []), (0, [])),
        page,
        two("a percept without digits", b"front;"),
        two("percepts without digits among others", b"a;", b"b(1);", b"c;", b"d;", b"e(22);"),
        two("leading zeros", b"t(007,0,00);"),
        two("signs and points belong to the shape", b"t(-12.50,+3e-4);"),
        two("a free half byte", b"a(1);", b"b(12);", b"c(123);"),
        two("an even number of half bytes", b"a(1);"),
        two("numbers in quotes and names", b"say(\"route 66\",'a1');", b"s2(3);"),
        two("a number at the begin of a text", b"7;", b"8x9;"),
        two("digits of any length", b"big(" + b"9876543210" * 20 + b");"),
        two("twelve sensors", *twelve),
        case("digits change, signs make a new shape", (0, [b"x(5);"]), (1, [b"x(1234);"]), (1, [b"x(-1234);"]), (2, [b"x(-1);", b"x(1);"])),
        case("the same shape twice in one answer", (0, [b"ball(1,2);", b"ball(3,44);"]), (1, [b"ball(5,6);", b"ball(7,88);"])),
        case("the same text three times", (0, [b"a;"] * 3), (1, [b"a;"] * 3)),
        case("runs in another order", (0, [b"a(1);", b"b(2);", b"c(3);", b"d(4);"]),
             (4, [b"c(5);", b"d(6);", b"a(7);", b"b(8);", b"d(9);", b"c(0);"])),
        case("a run is interrupted by a new text", (0, [b"a(1);", b"b(2);"]), (2, [b"a(3);", b"new(4);", b"b(5);"]),
             (3, [b"a(3);", b"b(5);", b"new(6);"])),
        case("less is known than was sent", (0, [b"a(1);", b"b(2);", b"c(3);"]), (1, [b"a(4);", b"b(5);", b"c(6);"])),
        case("nothing is known any more", (0, [b"a(1);"]), (1, [b"a(2);"]), (0, [b"a(3);"]), (1, [b"a(4);"])),
        case("fewer percepts, then all again", (0, [b"a(1);", b"b(2);", b"c(3);"]), (3, [b"b(9);"]), (3, []),
             (3, [b"a(1);", b"b(2);", b"c(3);"])),
        two("a table for two", b"a(1);", b"b(2);", b"c(3);", b"d(4);", shapes=2),
        case("a full table keeps what it has", (0, [b"a(1);"]), (1, [b"b(2);", b"a(3);"]), (1, [b"a(4);", b"b(5);"]), shapes=1),
        two("no table", b"a(1);", b"b(2);", shapes=0),
        two("126 shapes and one more", *full),
        two("a text of 255 bytes", b"t(\"" + b"x" * 249 + b"\");"),
        two("a text of 256 bytes", b"t(\"" + b"x" * 250 + b"\");"),
        two("a text of 255 bytes with digits", b"t(" + b"1" * 250 + b"x);"),
        two("a text of 510 bytes", b"t(\"" + b"x" * 504 + b"\");"),
        two("a text of 511 bytes between others", b"a(1);", b"t(\"" + b"y" * 505 + b"\");", b"b(2);"),
        two("'#', quotes, commas and brackets", b"a('#',\"#;\\\"1\");", b"b([1,{2}],(3));"),
        two("bytes above 7F", b"say(\"\xe4\xf6\xfc\xa4\xa5\xff 1\");", b"\x80(2);"),
        two("all digits", b"a(0123456789);"),
        two("a text without its separator", b"a(1);", b"rest(2)"),
    ]


def void():
    def case(name, *answers):
        reader, shown = Reader(), []
        for items in answers:
            texts = reader.read(items)
            shown.append({"itemsHex": items.hex(), "texts": texts and [text(t) for t in texts] if texts != [] else [],
                 "known": reader.known()})
        return {"name": name, "answers": shown}

    a, b = b"\x00\x05a(1);", b"\x01\x05b(2);"
    return [
        case("an id that is not known", b"\x80\x01\x1f", a + b, b"\x81\x02\x1f\x2f", a + b, b"\x80\x02\x1f\x2f"),
        case("known are the ids without a gap", b"\x01\x05b(2);", a, b"\x03\x05d(4);", b"\x02\x02c;", b"\x80\x04\x7f\x8f\x9f"),
        case("digits that end too soon", a + b, b"\x80\x02\x1f\x2a", a + b, b"\x80\x02\x1f", a + b, b"\x80\x01\x12\x34", a, b"\x80\x01"),
        case("a half byte that is no digit", a, b"\x80\x01\xaf"),
        case("a free half byte that is no F", a, b"\x80\x01\x12\xf5"),
        case("no percept, and ids that there are not", a, b"\x80\x00", a, b"\xfe\x01\x1f", a, b"\xff\x01\x1f"),
        case("a number without digits", a, b"\x80\x01\xff"),
        case("a text that is cut", a, b"\x00\x05a(1)", a, b"\x00"),
        case("what is in front of an item that cannot be read is void too", a, b + b"\x85\x01\x1f"),
        case("a continued text that ends nowhere", a, b"\x7e\x02ab", a, b"\x7e\x02ab\x00\x02c;", a, b"\x7e\x02ab\x80\x01\x1f"),
        case("a continued text in three", b"\x7e\x02ab\x7e\x01c\x7f\x02d;", b"\x7f\x02x;"),
        case("a newer text for an id counts", a, b"\x00\x02n;", b"\x80\x01", b"\x00\x05z(7);", b"\x80\x01\x9f"),
        case("items that are not joined", a + b, b"\x80\x01\x3f\x81\x01\x4f"),
    ]


# ---- parts ----

def part_splits():
    def case(name, request, answer, size):
        made = parts.split(request, answer, size)
        return {"name": name, "request": request, "answerHex": answer.hex(), "size": size,
             "payloads": [(bytes([k]) + p).hex() for k, p in made]}

    answer = bytes(range(40))
    return [
        case("an empty answer", 1, b"", None),
        case("a whole answer of 254 bytes", 2, bytes(254), None),
        case("255 bytes are two parts", 3, bytes(255), None),
        case("506 bytes are two parts", 255, bytes(506), None),
        case("507 bytes are three parts", 4, bytes(507), None),
        case("parts of twelve bytes", 5, answer, 12),
        case("a whole answer of twelve bytes", 6, answer[:12], 12),
        case("thirteen bytes in parts of twelve", 7, answer[:13], 12),
        case("255 parts", 8, bytes(i % 251 for i in range(255)), 1),
    ]


def assembled():
    def case(name, *payloads):
        assembly = parts.Assembly()
        answers = [assembly.take(p[0], p[1:]) for p in payloads]
        return {"name": name, "payloads": [p.hex() for p in payloads],
             "answers": [{"request": a[0], "itemsHex": a[1].hex()} for a in answers if a]}

    return [
        case("a whole answer", b"\x82\x01abc"),
        case("two parts", b"\x83\x01\x00abc", b"\x84\x01\x01def"),
        case("one part that is the last", b"\x84\x01\x00abc"),
        case("flags belong to no kind", b"\xc3\x01\x00abc", b"\xa3\x01\x01d", b"\xe4\x01\x02ef"),
        case("the first is missing", b"\x83\x01\x01abc", b"\x84\x01\x02def"),
        case("one in the middle is missing", b"\x83\x01\x00abc", b"\x84\x01\x02def"),
        case("one behind the missing one is the next number after all", b"\x83\x01\x00a", b"\x83\x01\x02c", b"\x84\x01\x01b"),
        case("the last is missing, then the next answer", b"\x83\x01\x00abc", b"\x83\x02\x00x", b"\x84\x02\x01y"),
        case("a part of another request", b"\x83\x01\x00abc", b"\x84\x02\x01def"),
        case("a whole answer between parts", b"\x83\x01\x00abc", b"\x82\x02z", b"\x84\x01\x01def"),
        case("a part twice", b"\x83\x01\x00a", b"\x83\x01\x01b", b"\x83\x01\x01b", b"\x84\x01\x02c"),
        case("from the beginning again", b"\x83\x01\x00a", b"\x83\x01\x00a", b"\x84\x01\x01b"),
        case("unasked", b"\x82\x00abc"),
        case("255 parts", *[bytes([0x83, 9, i, i]) for i in range(254)], b"\x84\x09\xfe\xfe"),
    ]


# ---- vocabulary ----

def vocabularies():
    def case(name, actions, room):
        pages, first = [], 0
        while first < len(actions) or not pages:
            page = vocabulary.write_page(len(pages) + 1, actions, first, room)
            read = vocabulary.read_page(page)[3]
            pages.append({"request": len(pages) + 1, "first": first, "payloadHex": page.hex(), "actions": [[text(n), a] for n, a in read]})
            first += len(read)
        numbers = {text(n): vocabulary.number_of(actions, n) for n, _ in actions}
        return {"name": name, "room": room, "pages": pages, "numbers": {n: i for n, i in numbers.items() if i is not None}}

    robot = [(b"front", 0), (b"left", 0), (b"speed", 1), (b"say", 0xFF), (b"stop", 0)]
    return [
        case("no action", [], 252),
        case("one page", robot, 252),
        case("pages of twenty bytes", robot, 20),
        case("the newest of one name counts", robot + [(b"front", 1), (b"left", 0)], 252),
        case("more actions than there are numbers", [(b"a%d" % i, 0) for i in range(130)], 252),
        case("names with bytes above 7F", [(b"m\xfcde", 0)], 252),
    ]


# ---- rules ----

def rule_cases():
    def case(name, command, *percepts):
        try:
            rule = rules.read(command)
        except rules.Malformed:
            return {"name": name, "command": text(command), "met": None}
        assert isinstance(rule, rules.Rule), name
        return {"name": name, "command": text(command), "percepts": [text(p) for p in percepts],
             "met": [rules.met(rule, p) for p in percepts]}

    def on(conditions):
        return b"\x07d\x00" + conditions

    one = (b"d(39);", b"d(40);", b"d(41);", b"d(-40);", b"d(40.0);", b"d(040);", b"d(39.99);", b"d(a);", b"d;", b"e(39);", b"d(\"40\");")
    words = (b"d(f);", b"d(fl);", b"d(\"f\");", b"d(1);", b"d;", b"d( f );", b"d(F);")
    refused = [
        ("number 0", b"\x00d\x00"), ("no functor", b"\x07\x00"), ("a functor without its end", b"\x07d"),
        ("place 0", on(b"0<40\x00")), ("a place that is no digit", on(b"a<40\x00")), ("an unknown operator", on(b"1?40\x00")),
        ("a value without its end", on(b"1<40")), ("no value", on(b"1<\x00")), ("less than an atom", on(b"1<f\x00")),
        ("no second value", on(b"1<40\x01\x00")), ("only a second value", on(b"1<\x0150\x00")),
        ("three values", on(b"1<40\x0150\x0160\x00")), ("a second value that is an atom", on(b"1<40\x01f\x00")),
        ("a condition that is cut", on(b"1")), ("a reflex without text", on(b"\x02")),
    ]
    return [
        case("less", on(b"1<40\x00"), *one),
        case("greater", on(b"1>40\x00"), *one),
        case("at most", on(b"1{40\x00"), *one),
        case("at least", on(b"1}40\x00"), *one),
        case("equal numbers", on(b"1=40\x00"), *one),
        case("different numbers", on(b"1!40\x00"), *one),
        case("a sign and a point", on(b"1<-1.5\x00"), b"d(-2);", b"d(-1.5);", b"d(-1.50001);", b"d(-1);", b"d(0);", b"d(2);", b"d(+1);",
             b"d(-10);"),
        case("zero has no sign", on(b"1=0\x00"), b"d(0);", b"d(-0);", b"d(0.000);", b"d(00);", b"d(0.001);"),
        case("long numbers", on(b"1>9999999999.999\x00"), b"d(10000000000);", b"d(9999999999.9991);", b"d(9999999999.999);",
             b"d(9999999999.9989);"),
        case("equal texts", on(b"1=f\x00"), *words),
        case("different texts", on(b"1!f\x00"), *words),
        case("a text in quotes", on(b"1=\"f\"\x00"), *words),
        case("two conditions", on(b"1=f\x002<40\x00"), b"d(f,39);", b"d(f,40);", b"d(l,39);", b"d(f);", b"d(f,39,x);"),
        case("twice the same place", on(b"1>10\x001<20\x00"), b"d(10);", b"d(15);", b"d(20);"),
        case("the ninth place", on(b"9=1\x00"), b"d(1,1,1,1,1,1,1,1,1);", b"d(1,1,1,1,1,1,1,1);", b"d(0,0,0,0,0,0,0,0,1,5);"),
        case("two values, of a rule that was not met before", on(b"1<40\x0150\x00"), *one),
        case("no condition", on(b""), b"d;", b"d(1);", b"dd;", b"e;"),
        case("with a reflex", on(b"1<40\x00\x02stop(now)"), b"d(39);", b"d(41);"),
        case("arguments with commas, quotes and brackets", on(b"3<5\x00"),
             b"d([1,2],\"a,b)\",4);", b"d(p(1,2),'x,y',5);", b"d(a,b,4)[source(x),n(9)];", b"d(\"\\\",\",0,4);"),
        case("a functor with other letters", b"\xffdist2\x001}100\x00", b"dist2(100);", b"dist(100);", b"dist22(100);"),
        *[case("refused: " + name, command) for name, command in refused],
    ]


# ---- board ----

def conversations():
    return [converse(*c) for c in CONVERSATIONS]


def converse(name, has, *steps):
    description = {"actions": [["front", 0], ["left", 0], ["speed", 1], ["bump", 0], ["grip", 0]], "refuses": ["bump"],
         "later": ["grip"]} | has
    program = Program([(raw(n), a) for n, a in description["actions"]], map(raw, description["refuses"]), map(raw, description["later"]),
                      map(raw, description.get("kinds", ())))
    device, shown, nonce = Device(program, 0), [], 0
    for step in steps:
        step, out = dict(step), []
        program.carried_out.clear()
        if "percepts" in step:
            program.texts = [raw(t) for t in step["percepts"]]
        if step.get("restart"):
            device, nonce = Device(program, 0), 0
        if "messages" in step:
            nonce = 0
            step["answers"] = [text(a) for m in step["messages"] for a in device.message(raw(m))]
        board = device.board
        for frame in map(read_frame, step.get("to", [])):
            if frame.kind == HELLO_KIND:
                nonce = frame.number
            # Frames of another session count as damaged and are ignored.
            if frame.kind == HELLO_KIND or board.session in (0, step.get("nonce", nonce)):
                out += board.receive(frame)
        if "report" in step:
            out += board.report(step["report"])
        if step.get("look"):
            out += board.look()
        if step.get("unasked"):
            out += board.percepts_unasked()
        step["from"] = [show(f) for f in out]
        if program.carried_out:
            step["carried"] = [text(t) for t in program.carried_out]
        shown.append(step)
    return {"name": name, "board": description, "steps": shown}


def to(*frames):
    return {"to": list(frames)}


def f(kind, number, payload=b""):
    return (bytes([kind, number]) + payload).hex()


def row(number, *items, resume=False):
    return f(0x31 if resume else 0x30, number, commands.write_row(items))


HELLO = to(f(0x10, 7))
FRONT, LEFT, SPEED, BUMP, GRIP = 0, 1, b"speed(5)", 3, 4
rule = commands.Rule
SET_RULE = rule(b"\x07dist\x002<40\x00\x02front")
KINDS = {"kinds": ["dist(f|b, cm 0..400)", "temp(\xb0C -40..125.5)", "ready"]}
CONVERSATIONS = [
    ("HELLO and WELCOME", {}, HELLO, to(f(0x10, 7)), to(f(0x10, 8))),
    ("without a session everything is answered with WELCOME 00", {}, to(row(0, FRONT)), to(f(0x20, 1, b"\x00")), to(f(0x28, 1, b"\x00")),
     to(row(0, FRONT, resume=True)), HELLO, to(row(0, FRONT))),
    ("commands in turn", {}, HELLO, to(row(0, FRONT)), to(row(1, SPEED, LEFT)), to(row(3, FRONT), row(4, LEFT))),
    ("no command is an ACK", {}, HELLO, to(row(0)), to(row(200))),
    ("a repetition is passed over", {}, HELLO, to(row(0, FRONT, LEFT)), to(row(0, FRONT, LEFT)), to(row(1, LEFT, SPEED)),
     to(row(0, FRONT, LEFT, SPEED, FRONT))),
    ("a gap is not jumped", {}, HELLO, to(row(1, LEFT)), to(row(0, FRONT)), to(row(2, SPEED)), to(row(1, LEFT, SPEED))),
    ("FE uses a number up", {}, HELLO, to(row(0, None, FRONT)), to(row(2, None)), to(row(2, LEFT)), to(row(3, FRONT))),
    ("a row that is cut", {}, HELLO, to(f(0x30, 0, b"\x80\x05spee")), to(f(0x30, 1, b"\x81\xff\x00\x80"))),
    ("numbers wrap", {}, HELLO, *[to(row(16 * i % 256, *[FRONT] * 16)) for i in range(15)], to(row(240, *[LEFT] * 15)),
     to(row(254, LEFT, FRONT, LEFT)),
     to(row(255, FRONT, LEFT, SPEED)), to(row(250, *[LEFT] * 10)), to(row(130, FRONT)), to(row(3, FRONT))),
    ("128 behind is passed over, 127 ahead is dropped", {}, HELLO, *[to(row(16 * i, *[FRONT] * 16)) for i in range(8)], to(row(0, LEFT)),
     to(row(255, LEFT)),
     to(row(128, LEFT)), to(row(1, SPEED)), to(row(0, SPEED))),
    ("a refusal holds what follows", {}, HELLO, to(row(0, FRONT, BUMP, LEFT)), to(row(2, LEFT)), to(row(3, SPEED)),
     to(row(0, FRONT, BUMP, LEFT)),
     to(row(2, LEFT, SPEED, resume=True)), to(row(2, LEFT, SPEED, resume=True)), to(row(4, FRONT))),
    ("RESUME counts for what is due alone", {}, HELLO, to(row(0, FRONT, BUMP)), to(row(0, FRONT, BUMP, LEFT, resume=True)),
     to(row(1, BUMP, LEFT, resume=True)),
     to(row(3, LEFT, resume=True)), to(row(2, LEFT, resume=True))),
    ("RESUME without commands", {}, HELLO, to(row(0, BUMP)), to(row(1, resume=True)), to(row(1, FRONT))),
    ("what follows RESUME may be refused again", {}, HELLO, to(row(0, BUMP, BUMP, FRONT)), to(row(1, BUMP, FRONT, resume=True)),
     to(row(1, BUMP, FRONT, resume=True)), to(row(2, FRONT, resume=True))),
    ("RESUME where nothing was refused", {}, HELLO, to(row(0, FRONT, resume=True)), to(row(0, FRONT, LEFT, resume=True))),
    ("FE for a refused command", {}, HELLO, to(row(0, BUMP, LEFT)), to(row(0, None, None)), to(row(1, None, FRONT, resume=True))),
    ("FE is not taken while a refusal holds", {}, HELLO, to(row(0, BUMP)), to(row(1, None)), to(row(1, None, resume=True))),
    ("unknown actions, wrong arguments", {}, HELLO, to(row(0, b"fly")), to(row(1, b"speed", resume=True)),
     to(row(2, b"front(1)", resume=True)),
     to(row(3, 2, resume=True)), to(row(4, 5, resume=True)), to(row(5, 125, resume=True)), to(row(6, b"speed(1)", resume=True))),
    ("an action of any number of arguments goes by number", {"actions": [["say", 255]]}, HELLO, to(row(0, 0, b"say", b"say(1,2)"))),
    ("BUSY, then done", {}, HELLO, to(row(0, FRONT, GRIP, LEFT)), to(row(1, GRIP, LEFT)), to(row(3, SPEED)), to(f(0x20, 1, b"\x00")),
     {"report": "done"},
     to(row(1, GRIP, LEFT, SPEED))),
    ("BUSY, then refused", {}, HELLO, to(row(0, GRIP, LEFT)), {"report": "refused"}, to(row(1, LEFT)), to(row(1, LEFT, resume=True))),
    ("RESUME while BUSY", {}, HELLO, to(row(0, BUMP)), to(row(1, GRIP, FRONT, resume=True)), to(row(1, GRIP, FRONT, resume=True)),
     {"report": "refused"},
     to(row(1, GRIP, FRONT, resume=True)), to(row(2, FRONT, resume=True))),
    ("FE while BUSY", {}, HELLO, to(row(0, GRIP)), to(row(0, None, FRONT)), {"report": "done"}, to(row(0, None, FRONT))),
    ("HELLO ends REFUSED", {}, HELLO, to(row(0, BUMP)), to(f(0x10, 9)), to(row(0, FRONT))),
    ("HELLO ends BUSY: the outcome of then counts no more", {}, HELLO, to(row(0, GRIP)), to(f(0x10, 9)), {"report": "done"},
     to(row(0, FRONT))),
    ("a restart", {}, HELLO, to(row(0, FRONT)), {"restart": True}, to(row(1, LEFT)), to(row(0, FRONT)), to(f(0x10, 9)), to(row(0, FRONT))),
    ("HELLO with another nonce: numbers begin anew", {}, HELLO, to(row(0, FRONT, LEFT)), to(f(0x10, 8)), to(row(0, FRONT))),
    ("HELLO that comes twice changes nothing", {}, HELLO,
     {"percepts": ["dist(f,50);"], "to": [row(0, SET_RULE, BUMP, LEFT), f(0x20, 1, b"\x00")]},
     to(f(0x10, 7)), to(row(2, LEFT, resume=True)), {"percepts": ["dist(f,39);"], "look": True}, to(f(0x20, 2, b"\x01"))),
    ("HELLO that comes twice leaves BUSY as it is", {}, HELLO, to(row(0, GRIP)), to(f(0x10, 7)), {"report": "done"}, to(row(1, LEFT))),
    ("HELLO 00 ends the session", {}, HELLO, to(row(0, FRONT)), to(f(0x10, 0)), to(row(1, LEFT)), to(f(0x10, 0))),
    ("frames of another session are passed over", {}, HELLO, to(row(0, FRONT)), {"to": [row(1, LEFT), f(0x20, 1, b"\x00")], "nonce": 9},
     to(row(1, LEFT)), to(f(0x10, 9)), {"to": [row(0, FRONT)], "nonce": 7}, to(row(0, LEFT))),
    ("without a session frames of any are answered with WELCOME 00", {}, {"to": [row(3, FRONT), f(0x20, 1, b"\x00")], "nonce": 9}, HELLO,
     to(row(0, FRONT))),
    ("a text is no rule", {}, HELLO, {"percepts": ["dist(f,39);"], "to": [row(0, b"\x07dist\x002<40\x00\x02front")]},
     to(row(1, b"\x01\x07dist\x002<40\x00\x02front", resume=True)), to(row(2, b"\x01", resume=True)), {"look": True}),
    ("a control character is no blank", {}, HELLO, to(row(0, b"\nfront")), to(row(1, b"front\n", resume=True)),
     to(row(2, b"\tspeed(5)", resume=True))),
    ("answers", {}, HELLO, {"percepts": ["dist(f,123);", "light(f,95);"], "to": [f(0x20, 1, b"\x00")]}, to(f(0x20, 2, b"\x02")),
     to(f(0x20, 255, b"\x01")),
     to(f(0x20, 1, b"\x02(light)")), to(f(0x20, 2, b"\x00(none)"))),
    ("answers carry what is due and REFUSED", {}, HELLO, {"percepts": ["dist(f,1);"], "to": [row(0, FRONT, BUMP), f(0x20, 1, b"\x00")]},
     to(f(0x20, 2, b"\x01"), row(2, LEFT, resume=True), f(0x20, 3, b"\x01"))),
    ("a computer that says it knows more than was sent", {}, HELLO, {"percepts": ["a(1);"], "to": [f(0x20, 1, b"\x09")]},
     {"percepts": ["a(2);", "b(3);"], "to": [f(0x20, 2, b"\x09")]}),
    ("HELLO forgets texts", {}, HELLO, {"percepts": ["a(1);", "b(2);"], "to": [f(0x20, 1, b"\x00")]},
     {"percepts": ["b(3);"], "to": [f(0x10, 8), f(0x20, 1, b"\x00")]}),
    ("percepts unasked", {}, {"percepts": ["a(1);"], "unasked": True}, HELLO, {"unasked": True}, to(f(0x20, 1, b"\x00")), {"unasked": True},
     to(f(0x20, 2, b"\x01")),
     {"percepts": ["a(2);", "b(3);"], "unasked": True}),
    ("DESCRIBE", {}, HELLO, to(f(0x28, 1, b"\x00")), to(f(0x28, 2, b"\x03")), to(f(0x28, 3, b"\x05")),
     to(row(0, BUMP), f(0x28, 4, b"\x04"))),
    ("kinds of percepts are asked for", KINDS, HELLO, {"percepts": ["dist(f,50);"], "to": [f(0x20, 1, b"\x00(?)")]},
     to(f(0x20, 2, b"\x00")), to(f(0x20, 3, b"\x01")), to(f(0x20, 4, b"\x01(?)"), f(0x20, 5, b"\x01(dist)"))),
    ("a board that describes no percepts", {}, HELLO, {"percepts": ["dist(f,50);"], "to": [f(0x20, 1, b"\x00(?)")]}),
    ("kinds of percepts take no ids from percepts", KINDS, HELLO, to(f(0x20, 1, b"\x00(?)")),
     {"percepts": ["ready;", "dist(f,50);"], "to": [f(0x20, 2, b"\x00")]}, to(f(0x20, 3, b"\x02"))),
    ("with rules set a description goes in parts of twelve bytes", KINDS, HELLO, to(row(0, rule(b"\x01a\x00")), f(0x20, 1, b"\x00(?)"))),
    ("other functors are no request for kinds", KINDS, HELLO,
     {"percepts": ["dist(f,50);"], "to": [f(0x20, 1, b"\x00(?,dist)"), f(0x20, 2, b"\x00(dist,?)"), f(0x20, 3, b"\x00(?")]}),
    ("a rule and its reflex", {}, HELLO, {"percepts": ["dist(f,41);"], "to": [row(0, SET_RULE)]}, {"look": True},
     {"percepts": ["dist(f,39);"], "look": True},
     {"look": True}, {"percepts": ["dist(f,38);"], "look": True}, {"percepts": ["dist(f,50);"], "look": True},
          {"percepts": ["dist(f,2);"], "look": True},
     {"percepts": [], "look": True}, {"percepts": ["dist(l,90);", "dist(f,39);", "dist(r,1);"], "look": True}),
    ("a rule with a second limit", {}, HELLO,
     {"percepts": ["dist(f,41);"], "to": [row(0, rule(b"\x07dist\x001=f\x002<40\x0145\x00\x02front"))]}, {"look": True},
     {"percepts": ["dist(f,39);"], "look": True}, {"percepts": ["dist(f,44);", "dist(l,39);"], "look": True},
     {"percepts": ["dist(f,45);"], "look": True}, {"percepts": ["dist(f,44);"], "look": True},
     {"percepts": ["dist(f,39);"], "look": True}, {"percepts": [], "look": True}, {"percepts": ["dist(f,44);"], "look": True}),
    ("a rule without a reflex, and one whose reflex is refused", {}, HELLO, to(row(0, rule(b"\x01a\x00"), rule(b"\x02b\x00\x02bump"))),
     {"percepts": ["b(2);", "a(1);"], "look": True}),
    ("a rule is met at once when it is set", {}, HELLO, {"percepts": ["dist(f,39);"], "to": [row(0, SET_RULE)]}, {"look": True},
     to(row(1, SET_RULE)), {"look": True}),
    ("rules are removed", {}, HELLO, {"percepts": ["a;", "b;"], "to": [row(0, rule(b"\x01a\x00"), rule(b"\x02b\x00"), rule(b"\x01"))]},
     {"look": True},
     to(row(3, rule(b"\x00"), rule(b"\x09"))), {"look": True}),
    ("HELLO forgets rules", {}, HELLO, to(row(0, rule(b"\x01a\x00"))), to(f(0x10, 8)), {"percepts": ["a;"], "look": True}),
    ("a rule that a board cannot watch is refused", {}, HELLO, to(row(0, rule(b"\x07d\x001?4\x00"), FRONT))),
    ("a reflex while a refusal holds, and BUSY", {}, HELLO, {"percepts": ["dist(f,3);"], "to": [row(0, SET_RULE, BUMP)]}, {"look": True},
     {"percepts": [], "to": [row(2, GRIP, resume=True)], "look": True}, {"percepts": ["dist(f,3);"], "look": True}, {"report": "done"}),
    ("with rules set an answer goes in parts of twelve bytes", {}, HELLO,
     {"percepts": ["dist(f,123);", "light(f,95);"], "to": [row(0, rule(b"\x01a\x00")), f(0x20, 1, b"\x00")]}, to(f(0x20, 2, b"\x02")),
          to(row(1, rule(b"\x00")), f(0x20, 3, b"\x00"))),
    ("a request of version 1 ends the session", {}, HELLO, to(row(0, FRONT, LEFT)),
     {"percepts": ["dist(f,1);"], "messages": ["getPercepts"]}, to(row(2, FRONT)), to(f(0x20, 1, b"\x00")), {"unasked": True},
     to(f(0x10, 8)), to(row(0, LEFT))),
    ("a command of version 1 ends the session", {}, HELLO, to(row(0, BUMP)), {"messages": ["front", "speed(5)", "fly"]},
     to(row(1, LEFT)), HELLO, to(row(0, LEFT))),
    ("version 1 ends BUSY: the outcome of then counts no more", {}, HELLO, to(row(0, GRIP)), {"messages": ["left"]}, {"report": "done"},
     HELLO, to(row(0, FRONT))),
    ("version 1 forgets rules", {}, HELLO, to(row(0, SET_RULE)), {"messages": ["left"]}, {"percepts": ["dist(f,3);"], "look": True},
     HELLO, {"look": True}),
]


GROUPS = {"frames": frames, "receive": receive, "commands": command_rows, "percepts": percepts, "void": void, "parts": part_splits,
          "assemble": assembled, "vocabulary": vocabularies, "rules": rule_cases, "board": conversations}


def vectors():
    return {"about": ABOUT} | {name: make() for name, make in GROUPS.items()}
