#!/usr/bin/env python3
"""Tests beyond the vectors: the values of actions and percepts, refusals, mistakes of programs, lines and their names."""
import pathlib
import socket
import sys
import tempfile
import threading
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT.parent / "javino-arduino" / "vectors")]
from javino2 import commands, frames, parts  # noqa: E402

import javino  # noqa: E402
from javino.hosts import open_named  # noqa: E402
from javino.lines import Port  # noqa: E402
from javino.literals import compare, split, term, value  # noqa: E402
from memory import Memory  # noqa: E402


class Bench:
    """A board, its far end and its clock."""

    def __init__(self, **options):
        self.now, self.line, self.carried = 0, Memory(), []
        self.nonce = 7  # nonce of the newest HELLO
        self.board = javino.Board(self.line, ticks=lambda: self.now, **options)

    def hear(self, kind, number, payload=b""):
        if kind == frames.HELLO:
            self.nonce = number
        self.line.arrives = frames.encode(frames.Frame(kind, number, payload), self.nonce)
        self.board.run()
        return self.sent()

    def sent(self):
        receiver = frames.Receiver(frames.FROM_BOARD)
        receiver.nonce = self.nonce
        receiver.receive(self.line.sent, 0)
        self.line.sent = b""
        return receiver.frames

    def greet(self):
        return self.hear(frames.HELLO, 7)

    def command(self, number, text, kind=frames.COMMANDS):
        return self.hear(kind, number, commands.write_row([text]))


class Descriptions(unittest.TestCase):
    def described(self, bench):
        bench.greet()
        return [frame.payload for frame in bench.hear(frames.ASK, 1, b"\0(?)")]

    def test_kinds_are_described_by_a_decorator_and_by_arguments(self):
        decorated, called = Bench(), Bench()

        @decorated.board.perceive("dist(cm 0..400)", "ready")
        def look():
            raise AssertionError("nobody asks for percepts")

        self.assertEqual(called.board.perceive(look, "dist(cm 0..400)", "ready"), look)
        for bench in (decorated, called):
            self.assertEqual(self.described(bench), [b"\x01\x7f\x11?dist(cm 0..400);\x7f\x07?ready;"])

    def test_a_function_without_kinds_describes_nothing_and_is_not_called(self):
        bench = Bench()
        bench.board.perceive(lambda: bench.board.percept("ready"))
        self.assertEqual(self.described(bench), [b"\x01"])

    def test_more_kinds_than_an_answer_holds_are_left_out_from_the_end_with_a_warning(self):
        bench = Bench()
        bench.board.perceive(lambda: None, *["p%d(%s)" % (i, "x" * 200) for i in range(400)])
        with self.assertWarnsRegex(RuntimeWarning, "at most 64515 bytes: the last kinds of percepts are left out"):
            described = self.described(bench)
        self.assertLessEqual(len(described), 255)
        kinds = b"".join(payload[2:] for payload in described)
        self.assertEqual(kinds.count(b"?p"), 300)
        self.assertTrue(kinds.endswith(b"x);"))


class Values(unittest.TestCase):
    def test_a_percepts_values_become_terms(self):
        for each, text in ((30, "30"), (-1, "-1"), (1.5, "1.5"), (True, "true"), (False, "false"), ("front", "front"),
                           ("Front", '"Front"'), ("", '""'), ("a b", '"a b"'), ('"\\\n', '"\\"\\\\\\n"'), ((), "[]"),
                           ([1, "x", ["Y"]], '[1,x,["Y"]]'), ("not", '"not"')):
            self.assertEqual(term(each), text)

    def test_what_has_no_term_is_refused_in_words(self):
        for each, error in ((float("nan"), ValueError), (float("-inf"), ValueError), (None, TypeError), ({}, TypeError)):
            with self.assertRaisesRegex(error, "a percept"):
                term(each)
        with self.assertRaisesRegex(ValueError, "ISO 8859-1"):
            Bench().board.percept("price", "5 €")

    def test_an_actions_arguments_become_values(self):
        for text, each in (("120", 120), ("-3.25", -3.25), ("1.0E-5", 1e-5), ("1e2", 100.0), ("left", "left"),
                           ('"a \\"b\\"\\n"', 'a "b"\n'), ("'Left'", "Left"), ("[1,2]", "[1,2]"), ("nan", "nan"), ("inf", "inf"),
                           ("1_0", "1_0"), ("p(1)", "p(1)"), ("+7", 7), ("e5", "e5"), ("0x10", "0x10"), ("X", "X")):
            self.assertEqual((value(text), type(value(text))), (each, type(each)))

    def test_texts_that_are_no_literals_are_known(self):
        for text in ("", "f(", "f)", "f(1", "f(1))", "f(,1)", "f()", "f(1,)", "f(1)g", "(1)", 'f("a)', "f([1)]", '"f"(1)', "f(1);g"):
            self.assertFalse(split(text)[2], text)
        for text in ("f", "f(1)", "f( 1 , [2,3] )", 'f(")")', "f(g(1,2),'x')", "f(1)[source(bob)]", "f[a]", "f(1);"):
            self.assertTrue(split(text)[2], text)

    def test_numbers_are_compared_exactly(self):
        for a, b, order in (("9007199254740993", "9007199254740992", 1), ("0.1", "0.10", 0), ("-0", "+0.0", 0), ("-2", "-1.5", -1)):
            self.assertEqual(compare(a, b), order)


class Registering(unittest.TestCase):
    def test_a_name_with_arguments_is_refused_in_words(self):
        for name in ("speed(1)", "", "a b(", "f;"):
            with self.assertRaisesRegex(ValueError, "arguments=1"):
                Bench().board.act[name] = print

    def test_there_is_room_for_126_actions_and_a_name_is_registered_once(self):
        board = Bench().board
        for _ in range(2):
            for i in range(126):
                board.act["a%d" % i] = print
        with self.assertRaisesRegex(ValueError, "126"):
            board.act["more"] = print

    def test_a_name_that_fits_on_no_page_of_the_vocabulary_is_refused_in_words(self):
        bench = Bench()
        bench.board.act["n" * 250] = print
        with self.assertRaisesRegex(ValueError, "at most 250 characters"):
            bench.board.act["n" * 251] = print
        bench.greet()
        found = bench.hear(frames.DESCRIBE, 1, b"\0")
        self.assertEqual([f.payload for f in found], [b"\x01\x00\x01\x00\xfa" + b"n" * 250])

    def test_an_action_without_the_right_number_of_arguments_is_refused_and_not_called(self):
        bench = Bench()
        bench.board.on_action("speed", bench.carried.append, 1)
        bench.greet()
        for i, text in enumerate((b"speed", b"speed(1,2)")):
            self.assertEqual(bench.command(i, text, frames.COMMANDS_RESUME), [frames.Frame(frames.ACK | frames.REFUSED, i + 1)])
        self.assertEqual(bench.carried, [])


class Acting(unittest.TestCase):
    def test_an_exception_refuses_the_action_reaches_the_program_and_the_action_is_not_tried_again(self):
        bench = Bench()
        calls = []

        def act():
            calls.append(1)
            raise KeyError("a defect of the program")
        bench.board.act["act"] = act
        bench.greet()
        with self.assertRaises(KeyError):
            bench.command(0, b"act")
        self.assertEqual(bench.sent(), [frames.Frame(frames.ACK | frames.REFUSED, 1)])
        self.assertEqual(bench.command(0, b"act"), [frames.Frame(frames.ACK | frames.REFUSED, 1)])
        self.assertEqual(len(calls), 1)

    def test_a_decorator_takes_the_number_of_arguments_by_its_name_or_without(self):
        bench = Bench()
        bench.board.on_action("speed", 1)(bench.carried.append)
        bench.board.on_action("turn", arguments=1)(bench.carried.append)
        bench.greet()
        bench.command(0, b"speed(5)")
        bench.command(1, b"turn(6)")
        self.assertEqual(bench.carried, [5, 6])
        with self.assertRaisesRegex(TypeError, "give the function behind the name"):
            bench.board.on_action("speed", "1")

    def test_run_within_an_action_keeps_what_arrives_for_later(self):
        bench = Bench()

        def slow():
            bench.line.arrives = frames.encode(frames.Frame(frames.COMMANDS, 1, commands.write_row([b"stop"])), bench.nonce)
            bench.board.run()
            bench.carried.append("slow")
        bench.board.act["slow"] = slow
        bench.board.act["stop"] = lambda: bench.carried.append("stop")
        bench.greet()
        self.assertEqual(bench.command(0, b"slow"), [frames.Frame(frames.ACK, 1)])
        self.assertEqual(bench.carried, ["slow"])
        bench.board.run()
        self.assertEqual((bench.carried, bench.sent()), (["slow", "stop"], [frames.Frame(frames.ACK, 2)]))

    def test_an_outcome_that_is_known_at_once_is_no_later_one(self):
        bench = Bench()
        bench.board.act["grip"] = lambda: bench.board.done(bench.board.later(), False)
        bench.greet()
        self.assertEqual(bench.command(0, b"grip"), [frames.Frame(frames.ACK | frames.REFUSED, 1)])

    def test_an_outcome_of_an_earlier_session_counts_no_more(self):
        bench, later = Bench(), []
        bench.board.act["grip"] = lambda: later.append(bench.board.later())
        bench.greet()
        self.assertEqual(bench.command(0, b"grip"), [frames.Frame(frames.ACK | frames.BUSY, 0)])
        bench.hear(frames.HELLO, 8)
        self.assertEqual((bench.board.done(later[0]), bench.sent()), (False, []))
        self.assertFalse(bench.board.done(0))

    def test_in_version_1_nobody_waits_and_a_name_that_may_be_cut_waits_for_what_follows(self):
        bench = Bench()
        for name in ("led", "ledOn"):
            bench.board.on_action(name, lambda name=name: bench.carried.append((name, bench.board.later())))
        bench.line.arrives = b"fffe05ledOn"
        bench.board.run()
        self.assertEqual(bench.carried, [("ledOn", 0)])
        bench.line.arrives = b"fffe03led"  # a damaged length: "On" follows
        bench.board.run()
        bench.now += 3
        bench.board.run()
        bench.line.arrives = b"On"
        bench.board.run()
        self.assertEqual(len(bench.carried), 1)
        bench.now += 200
        bench.board.run()
        bench.line.arrives = b"fffe03led"
        bench.board.run()
        bench.now += 7
        bench.board.run()
        self.assertEqual(bench.carried[1:], [("led", 0)])


class Perceiving(unittest.TestCase):
    def test_a_request_for_functors_spares_the_others(self):
        bench, read = Bench(), []

        def look():
            bench.board.percept("dist", 1)
            bench.board.add_percept("light(2)")
            if bench.board.wants("temp"):
                read.append("temp")
        bench.board.perceive(look)
        bench.greet()
        self.assertEqual(bench.hear(frames.ASK, 1, b"\0(dist)")[0].payload, b"\x01\x00\x08dist(1);")
        self.assertEqual(read, [])

    def test_an_answer_that_no_message_holds_is_sent_whole_in_version_2_and_in_messages_of_whole_percepts_in_version_1(self):
        bench = Bench()
        bench.board.perceive(lambda: [bench.board.percept("p", i, "x" * 90) for i in range(20)])
        bench.greet()
        assembly = parts.Assembly()
        answers = [assembly.take(f.kind, f.payload) for f in bench.hear(frames.ASK, 1, b"\0")]
        self.assertEqual([a for a in answers if a][0][1].count(b"xx;"), 0)
        self.assertEqual([a for a in answers if a][0][1].count(b";"), 20)
        bench.now += 30
        bench.board.run()
        bench.line.arrives = b"fffe0BgetPercepts"
        bench.board.run()
        self.assertEqual(bench.line.sent.count(b"fffe"), 10)

    def test_more_than_any_answer_holds_is_left_out_and_the_rest_is_sent(self):
        bench = Bench()
        bench.board.perceive(lambda: [bench.board.percept("p%d" % i, "x" * 200) for i in range(400)])
        bench.greet()
        with self.assertWarnsRegex(RuntimeWarning, "at most 64515 bytes: the last percepts are left out"):
            found = bench.hear(frames.ASK, 1, b"\0")
        self.assertLessEqual(len(found), 255)
        self.assertEqual(found[-1].kind, frames.LAST_PART)

    def test_percepts_that_nobody_asks_for_take_a_bounded_room_and_go_out_when_told_to(self):
        bench = Bench()
        self.assertTrue(all(bench.board.percept("p", i) for i in range(400)))
        self.assertFalse(all(bench.board.percept("p", i) for i in range(1000)))
        bench.board.clear_percepts()
        bench.greet()
        bench.board.percept("button", 1)
        bench.board.send_percepts()
        self.assertEqual([f.payload for f in bench.sent()], [b"\x00\x00\x0abutton(1);"])

    def test_a_reflex_overtakes_a_long_answer_on_a_slow_line(self):
        bench = Bench(baud=9600)
        near = []
        bench.board.perceive(lambda: [bench.board.percept("dist", i, 5 if near else 100) for i in range(8)])
        bench.board.act["stop"] = lambda: bench.carried.append(bench.now)
        bench.board.watch_rules()
        bench.greet()
        bench.command(0, commands.Rule(b"\x01dist\x002<40\x00\x02stop"))
        bench.now += 100
        found, begin = bench.hear(frames.ASK, 1, b"\0"), bench.now
        self.assertLess(len(found), 3)
        near.append(1)
        while bench.now < begin + 400:
            bench.now += 1
            bench.board.run()
        found += bench.sent()
        kinds = [f.kind for f in found]
        self.assertLess(kinds.index(frames.CRITICAL), kinds.index(frames.LAST_PART))
        self.assertLess(bench.carried[0] - begin, 8)


class Lines(unittest.TestCase):
    def test_names_that_are_none_are_refused_in_words(self):
        for name, words in (("tcp://robot", "tcp://HOST:PORT"), ("tcp:4000", "tcp://HOST:PORT"), ("tcp://h:x", "tcp://HOST:PORT"),
                            ("usb:1", "names no line")):
            with self.assertRaisesRegex(ValueError, words):
                open_named(name)
        with self.assertRaisesRegex(TypeError, "any or in_waiting"):
            javino.Board(b"")
        with self.assertRaises(FileNotFoundError):
            open_named("/dev/no_such_port")
        with tempfile.NamedTemporaryFile() as file, self.assertRaisesRegex(OSError, "is no serial port"):
            open_named(file.name)

    def test_a_link_to_a_pseudo_terminal_is_made_and_taken_away(self):
        with tempfile.TemporaryDirectory() as folder:
            link = pathlib.Path(folder) / "board"
            for _ in range(2):
                line = open_named("pty:%s" % link)
                self.assertEqual(str(link.resolve()), line.name)
                line.close()
                self.assertFalse(link.is_symlink())

    def test_writing_to_a_far_end_that_does_not_read_ends(self):
        line = open_named("pty")
        began = threading.Thread(target=lambda: line.write(b"x" * 100000), daemon=True)
        began.start()
        began.join(20)
        self.assertFalse(began.is_alive())
        line.close()

    def test_a_computer_on_the_network_that_goes_is_followed_by_the_next(self):
        line = open_named("tcp://127.0.0.1:0")
        host, number = line.name[6:].split(":")
        board = javino.Board(line)
        board.perceive(lambda: board.percept("dist", 30))
        for _ in range(3):
            with socket.create_connection((host, int(number))) as computer:
                computer.settimeout(5)
                computer.sendall(b"fffe0BgetPercepts")
                end, data = time.monotonic() + 10, b""
                while len(data) < 15 and time.monotonic() < end:
                    board.wait(10)
                    board.run()
                    try:
                        computer.setblocking(False)
                        data += computer.recv(100)
                    except BlockingIOError:
                        pass
                self.assertEqual(data, b"fffe09dist(30);")
        line.close()

    def test_a_port_that_takes_less_than_it_is_given_is_written_to_again(self):
        class Uart:
            written, waiting = b"", b"ab"

            def any(self):
                return len(self.waiting)

            def read(self, count):
                return self.waiting[:count]

            def write(self, data):
                self.written += data[:3]
                return len(data[:3])
        port = Port(Uart())
        port.write(b"abcdefgh")
        self.assertEqual((port._port.written, port.read()), (b"abcdefgh", b"ab"))

    def test_the_end_of_the_input_ends_a_program(self):
        import subprocess
        program = "import sys; sys.path.insert(0, sys.argv[1]); import javino; javino.Board().run_forever()"
        command = [sys.executable, "-c", program, str(ROOT)]
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)
        self.assertIn("LineGone: standard input and output has ended", done.stderr)


unittest.main()
