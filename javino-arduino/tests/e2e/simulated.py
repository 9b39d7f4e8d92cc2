#!/usr/bin/env python3
"""The sketches on the simulated ATmega328P, or on a microcontroller under QEMU, end to end over a pseudo-terminal. Prints what it measures.

    simulated.py [--board uno|MACHINE] [--damaged SECONDS] [PART OF A CASE'S NAME...]
"""
import argparse
import os
import random
import select
import subprocess
import sys
import termios
import time

from board import PATIENCE, ROOT, Board, Session, commands, frame1, frames, kind_of, simulator_of, version1
from cases import check, damage_one_in_200, equal, texts
from machine import MACHINES


def figure(text):
    """Prints a measured figure."""
    print("  " + text if Board.kind == "uno" else f"  {Board.kind}: {text}")


# ---- behaviour of sketches ----

def an_led_follows_actions_in_both_versions():
    with Board("Blink") as board:
        board.line.ready()
        board.watch(13)
        board.await_pin(13, "low")
        board.line.write(frame1(b"ledOn"))
        board.await_pin(13, "high")
        equal(board.line.ask(), "ledStatus(on);")
        session = Session(board.line)
        equal(session.vocabulary(), [("ledOn", 0), ("ledOff", 0)])
        equal((session.send("ledOff"), session.refused), (1, False))
        board.await_pin(13, "low")
        equal((session.send("fly"), session.refused), (1, True))
        equal((session.send(0, 1, 0), session.refused), (3, False))
        board.await_pin(13, "high")
        equal(session.ask(), "ledStatus(on);")
        session.send("ledOff")
        for _ in range(3):
            equal(session.ask(), "ledStatus(off);")
        time.sleep(0.1)
        board.line.write(frame1(b"fly"))
        time.sleep(0.1)
        equal(board.line.ask(), "ledStatus(off);")


def a_command_and_a_request_in_one_burst_are_both_handled():
    with Board("Blink") as board:
        board.line.ready()
        for action, status in ((b"ledOn", "on"), (b"ledOff", "off")) * 5:
            board.line.write(frame1(action) + frame1(b"getPercepts"))
            equal(board.line.message(), f"ledStatus({status});")


def a_repeated_command_is_carried_out_once():
    with Board("Echo") as board:
        board.line.ready()
        session = Session(board.line)
        for _ in range(4):
            board.line.send(frames.Frame(frames.COMMANDS, 0, commands.write_row([b"speed(100)", b"stop"])))
            found = []
            while frames.ACK not in [f.kind for f in found]:
                found = board.line.frames(5.0)
                check(found, "no answer")
            equal([f.number for f in found if f.kind == frames.ACK], [2])
        equal(session.ask(), "count(2);")


def a_program_of_version_1_is_understood_behind_one_of_version_2():
    with Board("Echo") as board:
        board.line.ready()
        Session(board.line).send("speed(100)")
        time.sleep(0.2)
        for i in range(50):
            board.line.write(frame1(f"speed({100 + i})".encode()))
            time.sleep(0.02)  # shorter than the pause that a session wants
        equal(board.line.ask(), "count(51);")


def analogue_inputs_become_percepts(robot="Robot4WD"):
    with Board(robot) as board:
        board.command("mux A4 2 4")
        board.command("mux A5 2 4")
        expected = ""
        for i, side in enumerate("fbrl"):
            board.command(f"set A{i} {400 + 500 * i}")
            board.command(f"set A4.{i} {1000 * (i + 1)}")
            board.command(f"set A5.{i} {200 + 50 * i}")
            steps = [mv * 1023 // 5000 for mv in (400 + 500 * i, 1000 * (i + 1), 200 + 50 * i)]
            expected += f"dist({side},{steps[0] * 127 // 100});light({side},{steps[1]});"
            expected += f"temp({side},{steps[2] * 500 // 1023});"
        board.line.ready()
        equal(board.line.ask(), expected)
        session = Session(board.line)
        for _ in range(3):
            equal(session.ask(), expected)
        equal([p.split("(")[0] for p in session.ask("(dist)").split(";")[:-1]], ["dist"] * 4)
        if robot == "Robot4WD":
            equal(session.ask("(?)"), "?dist(f|b|r|l, cm 0..650);?light(f|b|r|l, 0..1023);?temp(f|b|r|l, C 0..150);")


def a_greenhouse_shows_its_sensors_and_switches_its_devices():
    with Board("Greenhouse") as board:
        for pin, millivolts in (("A0", 290), ("A1", 2250), ("A2", 2500)):
            board.command(f"set {pin} {millivolts}")
        board.line.ready()
        for pin in (7, 8):
            board.watch(pin)
        board.line.write(frame1(b"set(pump,on)") + frame1(b"set(vent,on)"))  # a vent is open or closed
        board.await_pin(7, "high")
        equal(board.line.ask(), "temp(28.84);soil(50);light(511);state(pump,on);state(vent,closed);")


def motors_stop_when_the_far_end_falls_silent():
    with Board("LinkLost") as board:
        board.line.ready()
        board.watch(5)
        board.line.write(frame1(b"speed(150)"))
        begin = board.await_pin(5, "pwm 150")
        end = board.await_pin(5, "low")
        # The board counts whole milliseconds of its own, from when it looked for bytes; under QEMU it may be halted before it acts on them.
        check((297 if board.kind == "uno" else 200) <= end - begin < 400, f"stopped {end - begin} ms after the last message")
        equal(board.line.ask(), "motor(0);stopped(linkLost);")
        equal(board.line.ask(), "motor(0);")
        figure(f"motor stopped {end - begin:.0f} ms after the last message (set: 300 ms)")


def motors_stop_when_the_far_end_closes_the_line(robot="Robot4WD"):
    with Board(robot) as board:
        board.line.ready()
        for pin in (5, 6, 7, 9):
            board.watch(pin)
        board.line.write(frame1(b"speed(120)") + frame1(b"front"))
        for pin, state in ((5, "pwm 120"), (6, "pwm 120"), (7, "high"), (9, "high")):
            board.await_pin(pin, state)
        board.line.close()
        for pin in (5, 6, 7, 9):
            board.await_pin(pin, "low")
        board.line = type(board.line)(board.port)
        board.line.ready()


def a_reflex_is_carried_out_by_the_board_itself(robot="Robot4WD"):
    with Board(robot) as board:
        board.command("set A0 2500")
        board.line.ready()
        session = Session(board.line)
        check(session.welcome[3] > 0, "the board holds no rules")
        session.send(commands.Rule(b"\x01dist\x001=f\x002<40\x00\x02stop"), "front")
        equal(session.refused, False)
        board.watch(7)
        board.await_pin(7, "high")
        took = []
        for _ in range(10):
            # While an answer is on its way, too.
            board.line.send(frames.Frame(frames.ASK, 9, bytes([session.texts.known()])))
            begin = float(board.command("time"))
            board.command("set A0 100")
            took.append(board.await_pin(7, "low") - begin)
            found = []
            end = time.monotonic() + 5
            while not any(kind_of(f) == frames.CRITICAL for f in found) and time.monotonic() < end:
                found += board.line.frames(0.5)
            told = [f.payload for f in found if kind_of(f) == frames.CRITICAL]
            equal(told, [b"\x01\x01dist(f,%d);" % (100 * 1023 // 5000 * 127 // 100)])
            board.command("set A0 2500")
            time.sleep(0.05)
            session.send("front")
            board.await_pin(7, "high")
        pace = " at 9600 baud" if board.kind == "uno" else ""
        figure(f"from the reading to the reflex: {max(took):.1f} ms at most of 10, with 12 sensors{pace}")
        equal(session.ask("(light)").count("light("), 4)


def opening_the_line_resets_the_board_and_readiness_is_an_answer():
    with Board("Echo", "--reset-on-open", "--boot-ms", "2000") as board:
        begin = time.monotonic()
        board.line.ready()
        check(time.monotonic() - begin >= 0.5, "the boot loader took no time")
        board.line.write(frame1(b"ledOn"))
        equal(board.line.ask(), "count(1);")
        board.line.close()
        board.line = type(board.line)(board.port)
        board.line.ready()
        equal(board.line.ask(), "count(0);")


def messages_of_255_bytes_go_both_ways():
    with Board("Bare") as board:
        board.line.ready()
        text = "say(" + "x" * 250 + ")"
        board.line.write(frame1(text.encode()))
        equal(board.line.message(), text)
        session = Session(board.line)
        equal(session.welcome[2], 255)
        equal(session.send(text[:252] + ")"), 1)


def sketches_for_earlier_libraries_run():
    with Board("Callbacks") as board:
        board.command("set A0 2500")
        board.line.ready()
        board.line.write(frame1(b"lampOn"))
        percepts = board.line.ask().split(";")
        equal(percepts[1:], ["half(255.50)", "lamp(on)", 'name("the board")', ""])
    with Board("Messages") as board:
        board.line.ready()
        board.line.write(frame1(b"lampOn"))
        equal(board.line.ask(), "device(testBoard);firmware(\"test board\");lamp(on);")
        equal(board.line.ask("hello"), "heard(hello);")
        equal(Session(board.line).ask("(lamp)"), "lamp(on);")
    with Board("Oldest") as board:
        board.command("set A0 2500")
        board.line.ready()
        board.line.write(frame1(b"lampOn"))
        equal(board.line.ask(), "light(511);lamp(1);")


def the_distance_of_a_sonar_is_a_percept():
    with Board("Ultrasonic") as board:
        board.line.ready()
        await_answer(board.line, "silent(sonar);")
        session = Session(board.line)
        for cm in (30, 5, 250, 400):
            board.command(f"sonar 2 {cm}")
            await_answer(session, f"dist({cm});")
        board.command("sonar 2 0")
        await_answer(session, "clear;")
        # Under a stream of requests, whose bytes interrupt too.
        board.command("sonar 2 77")
        await_answer(session, "dist(77);")
        seen = {session.ask() for _ in range(50)}
        equal(seen - {"dist(76);", "dist(77);", "dist(78);"}, set())


def a_servo_is_sent_pulses_of_the_angle_that_it_goes_to():
    with Board("ServoArm") as board:
        board.line.ready()
        session = Session(board.line)
        equal(session.ask(), "angle(90);")
        board.watch(9)
        check(abs(pulse(board) - 1472) < 20, "the pulse of 90 degrees has another length")
        for refused in ("angle(181)", "angle(-1)", "angle(x)", "angle"):
            session.send(refused)
            equal(session.refused, True)
        begin = float(board.command("time"))
        equal((session.send("angle(150)"), session.refused), (1, False))
        check("moving;" in session.ask(), "the arm does not move")
        await_answer(session, "angle(150);")
        took = float(board.command("time")) - begin
        check(600 <= took < 1500, f"60 degrees took {took} ms")
        check(abs(pulse(board) - 2091) < 20, "the pulse of 150 degrees has another length")
        # Without a word from the computer the arm stays where it is.
        session.send("angle(0)")
        begin = float(board.command("time"))
        while float(board.command("time")) < begin + 1300:
            time.sleep(0.01)
        angle = int(session.ask().split("(")[1].split(")")[0])
        check(20 <= angle <= 60, f"the arm stopped at {angle}")
        equal(session.ask(), f"angle({angle});")


def pulse(board):
    """Returns the length in microseconds of the next pulse on pin 9."""
    board.pins.clear()
    board.await_pin(9, "low")
    rose = board.await_pin(9, "high")
    return (board.await_pin(9, "low") - rose) * 1000


def a_pressed_button_is_reported_unasked():
    with Board("Button") as board:
        board.command("set 3 high")
        board.line.ready()
        equal(board.line.ask(), "pressed(0);")
        for n in (1, 2, 3):
            board.command("set 3 low")
            equal(board.line.message(), f"pressed({n});")
            hold(board, 30)
            board.command("set 3 high")
            hold(board, 30)
        equal(board.line.messages(0.2), [])
        equal(Session(board.line).ask(), "pressed(3);")


def hold(board, ms):
    begin = float(board.command("time"))
    while float(board.command("time")) < begin + ms:
        time.sleep(0.005)


def the_agents_line_may_be_on_two_other_pins():
    with Board("SoftwareLine", "--soft", "10,11,9600") as board:
        agent = board.second
        agent.ready()
        equal(agent.ask(), "led(off);")
        session = Session(agent)
        board.watch(13)
        for n in range(20):
            state = ("on", "off")[n % 2]
            equal((session.send("led" + state.capitalize()), session.refused), (1, False))
            equal(session.ask(), f"led({state});")
        board.await_pin(13, "high")
        equal(read_text(board.line, "off\r\n", 10).count("on\r\n"), 10)


def read_text(line, part, times):
    """Returns the output of a port until this part has come so many times."""
    text, until = "", time.monotonic() + PATIENCE
    while text.count(part) < times:
        check(time.monotonic() < until, f"printed was {text!r}")
        if select.select([line.fd], [], [], 0.1)[0]:
            text += os.read(line.fd, 4096).decode("latin1")
    return text


def two_computers_have_a_conversation_each():
    with Board("TwoComputers", "--soft", "10,11,9600") as board:
        board.command("set A0 2500")
        board.line.ready()
        board.second.ready()
        driver, watcher = Session(board.line), Session(board.second)
        board.watch(5)
        for n in range(10):
            equal((driver.send(f"speed({100 + n})"), driver.refused), (1, False))
            board.await_pin(5, f"pwm {100 + n}")
            equal(watcher.ask(), f"motor({100 + n});light(511);")
            watcher.send("speed(9)")
            equal(watcher.refused, True)
            equal((watcher.send("stop"), watcher.refused), (1, False))
            board.await_pin(5, "low")
            equal(driver.ask(), "motor(0);")
        driver.send("speed(200)")
        board.await_pin(5, "pwm 200")
        # The watcher by itself does not keep the motor going.
        board.await_pin(5, "low")
        equal(watcher.ask("(motor)"), "motor(0);")


def await_answer(asked, expected):
    """Asks until the answer is this one."""
    end = time.monotonic() + PATIENCE
    while (found := asked.ask()) != expected:
        check(time.monotonic() < end, f"the answer was {found}, not {expected}")


def a_robot_without_arduino_does_the_same():
    analogue_inputs_become_percepts("robot")
    motors_stop_when_the_far_end_closes_the_line("robot")
    a_reflex_is_carried_out_by_the_board_itself("robot")
    with Board("robot") as board:
        board.line.ready()
        session = Session(board.line)
        equal(session.vocabulary(), [("front", 0), ("back", 0), ("left", 0), ("right", 0), ("stop", 0), ("speed", 1)])
        for refused in ("fly", "speed(256)", "speed(x)", "speed", "speed(1,2)", "stop(1)"):
            session.send(refused)
            equal(session.refused, True)
        board.watch(5)
        equal((session.send("speed(77)", 0), session.refused), (2, False))
        board.await_pin(5, "pwm 77")


def another_rate_is_heard_as_on_a_wire():
    with Board("Stall") as board:
        board.line.ready()
        rate = rate_of_the_sketch("Stall")
        for wrong in (termios.B300, termios.B57600):
            set_rate(board.line, wrong)
            board.line.write(frame1(b"getPercepts"))
            equal(board.line.messages(1.0), [])
            set_rate(board.line, rate)
            board.line.ready()
            while True:
                begin = time.monotonic()
                board.line.write(frame1(b"stall(1500)") + frame1(b"getPercepts"))
                time.sleep(0.2)
                set_rate(board.line, wrong)  # so the answer is misheard
                in_time = time.monotonic() - begin < 1.0  # else the machine was halted, and the answer may have come before
                heard = board.line.messages(3.0)
                set_rate(board.line, rate)
                board.line.ready()
                if in_time or not heard:
                    break
            equal(heard, [])


def rate_of_the_sketch(name):
    begin = (ROOT / f"tests/sketches/{name}/{name}.ino").read_text().split("start(")[1]
    return getattr(termios, "B" + begin.split(")")[0])


def set_rate(line, rate):
    settings = termios.tcgetattr(line.fd)
    settings[4] = settings[5] = rate
    termios.tcsetattr(line.fd, termios.TCSANOW, settings)


# ---- time around the board ----

def what_the_simulator_does_not_understand_is_refused():
    def said(commands, *options):
        run = subprocess.run(simulator_of("uno", "Blink", *options), input=commands, capture_output=True, text=True, timeout=PATIENCE)
        return run.returncode, run.stdout + run.stderr
    status, text = said("send 100 16 6f0\nsend 100 16 6f no\nsend 100 16 6f6E\nsend 100 16 zz\nrun x\nquit\n", "--stepped")
    equal((status, [line.split(":")[0] for line in text.splitlines()]), (0, ["error", "error", "ok", "error", "error"]))
    status, text = said(f"set A0 {'1' * 300}\ntime\nquit\n")
    check("error: a command has fewer than 256 characters" in text and "\nok " in text, text)
    for wrong in ("soon", "", "12x"):
        status, text = said("", "--boot-ms", wrong)
        check(status == 2 and text.startswith("usage"), text)


def no_frame_is_lost_while_the_loop_stalls():
    rng = random.Random(5)
    for stall, sent in ((150, 60), (300, 40), (1000, 12)):
        for version in (1, 2):
            with Board("Stall") as board:
                board.line.ready()
                if version == 2:
                    Session(board.line)
                    command = lambda i: frames.encode(frames.Frame(frames.COMMANDS, i % 256, commands.write_row([b"count"])), board.line.nonce)
                    board.line.send(frames.Frame(frames.COMMANDS, 0, commands.write_row([f"stall({stall})".encode()])))
                else:
                    command = lambda i: frame1(b"count")
                    board.line.write(frame1(f"stall({stall})".encode()))
                due = float(board.command("time")) + 1000
                for i in range(1, sent + 1):
                    # By the board's clock; bytes that come in the meantime find room in its receive buffer.
                    while float(board.command("time")) < due:
                        time.sleep(0.005)
                    board.line.write(command(i))
                    due = float(board.command("time")) + stall * rng.uniform(0.25, 1)
                while float(board.command("time")) < due + 3 * stall:
                    time.sleep(0.005)
                board.line.messages()
                equal(board.line.ask().split(";")[0], f"count({sent})")
    figure("no command lost by a loop() of 150, 300 and 1,000 ms, in either version")


def a_slow_command_is_carried_out_once():
    with Board("Stall") as board:
        board.line.ready()
        session = Session(board.line)
        begin = float(board.command("time"))
        for at in (0, 160, 470, 1100, 2400):
            while float(board.command("time")) < begin + at:
                time.sleep(0.005)
            board.line.send(frames.Frame(frames.COMMANDS, 0, commands.write_row([b"slow(3300)"])))
        while float(board.command("time")) < begin + 4000:
            time.sleep(0.01)
        equal({(f.kind, f.number) for f in board.line.frames(2.0)}, {(frames.ACK, 1)})
        equal(session.ask().split(";")[0], "count(1)")


def an_outcome_is_reported_later_and_the_board_goes_on():
    with Board("Gripper") as board:
        board.line.ready()
        session = Session(board.line)
        for fingers, refused in (("high", False), ("low", True)):
            board.command(f"set 7 {fingers}")
            begin = float(board.command("time"))
            frame = frames.encode(frames.Frame(frames.COMMANDS, session.due, commands.write_row([b"close"])), board.line.nonce)
            board.line.write(frame)
            equal([(f.kind, f.number) for f in board.line.frames(5.0)], [(frames.ACK | frames.BUSY, session.due)])
            equal(session.ask(), "gripper(closing);")
            board.line.write(frame)
            equal([(f.kind, f.number) for f in board.line.frames(5.0)], [(frames.ACK | frames.BUSY, session.due)])
            found = board.line.frames(5.0)[0]
            took = float(board.command("time")) - begin
            equal((found.kind, found.number), (frames.ACK | (frames.REFUSED if refused else 0), session.due + 1))
            check(took >= 800, f"reported after {took} ms")
            equal(session.ask(), "gripper(closed);")
            session.due += 1


def reading_again_takes_a_bounded_time():
    with Board("Stall") as board:
        board.line.ready()
        for nasty in (b"fffeFF" * 45, b"fffe8012" * 38, b"\xa5\xff\x30\xa4\x04" * 60):
            board.line.write(nasty)
            time.sleep(0.5)
            board.line.ready()
        longest = int(board.line.ask().split("longest(")[1].split(")")[0])
        figure(f"the longest run() behind 300 bytes full of headers: {longest} microseconds")
        check(longest < 10000, f"run() took {longest} microseconds")


def a_burst_arrives_whole():
    with Board("Bytes") as board:
        time.sleep(0.5)
        for burst in (100, 5000, 20000):
            board.line.write(b"x" * burst + b"\n")
            data, end = b"", time.monotonic() + 20
            while not data.endswith(b"\n") and time.monotonic() < end:
                if select.select([board.line.fd], [], [], 0.1)[0]:
                    data += os.read(board.line.fd, 100)
            equal(data.strip(), str(burst).encode())


# ---- figures ----

BYTE_SECONDS = 10 / 115200


def requests_that_the_line_has_time_for_are_answered():
    with Board("Throughput") as board:
        board.line.ready()
        request = frame1(b"getPercepts")
        answer = 6 + len(board.line.ask())
        period = (len(request) + answer) * BYTE_SECONDS
        seconds, sent, answered = 5.0, 0, 0
        # By the board's clock and never closer, so that a slow machine is not taken for a slow board.
        due = float(board.command("time")) / 1000
        while sent * period < seconds:
            while (now := float(board.command("time")) / 1000) < due:
                answered += len(board.line.messages(min(0.002, due - now)))
            board.line.write(request)
            sent += 1
            due = now + period
        while found := board.line.messages(0.5):
            answered += len(found)
        share = 100.0 * answered / sent
        figure(f"throughput: {share:.1f} % of {sent} requests answered at 115200 baud, loop() of 5 ms,"
              f" answers of {answer} bytes, one request every {period * 1000:.1f} ms")
        lock_step, begin = 0, float(board.command("time"))
        while (passed := float(board.command("time")) - begin) < 3000:
            board.line.ask()
            lock_step += 1
        figure(f"one request after the other's answer: {lock_step * 1000 / passed:.0f} a second;"
              f" the line alone would allow {1 / period:.0f}")
        check(share >= 95, "fewer than 95 % answered")


def version_2_asks_more_often_than_version_1_could():
    with Board("Throughput") as board:
        board.line.ready()
        session = Session(board.line, patience=2.0)
        session.ask()
        asked, begin = 0, float(board.command("time"))
        while (passed := float(board.command("time")) - begin) < 3000:
            session.ask()
            asked += 1
        figure(f"version 2, one request after the other's answer: {asked * 1000 / passed:.0f} a second")
        equal(session.repeated, 0)


ACTIONS = {"led": "pwm 1", "ledOn": "pwm 2", "stop": "pwm 3"}


def duty_of(text):
    return ACTIONS.get(text) or "pwm " + text[6:-1]


def carried_out(board):
    """Returns the duty that pin 5 had at each change of pin 13."""
    duties, duty = [], None
    for pin, state, _ in board.changes():
        if pin == 5:
            duty = board.last_duty = state
        else:
            duties.append(duty or board.last_duty)
    return duties


DAMAGED_SECONDS = 5.0  # of actions on a damaged line, in each version
LEAST = 100  # of these actions, however long a busy machine takes for them


def on_a_damaged_line(version, run):
    rng, damaged = random.Random(8), [0]
    with Board("Echo") as board:
        board.line.ready()
        board.last_duty = None
        board.watch(5)
        board.watch(13)
        board.changes()
        # Here a swallowed frame is to be given up as soon as the protocol says.
        board.line.listen(100)
        board.line.damage = damage_one_in_200(rng, damaged)
        result = run(board, texts(rng), time.monotonic() + Board.damaged_seconds)
        board.line.damage = lambda data: data
        board.line.ready()
    figure(f"version {version}, {damaged[0]} bytes damaged in both directions: {result}")


def version_2_carries_out_every_command_once_on_a_damaged_line():
    def run(board, actions, end):
        session = Session(board.line, patience=0.06)
        sent, expected, duties = 0, [], []
        while time.monotonic() < end or sent <= LEAST:
            row = [next(actions) for _ in range(1 + sent % 4)]
            equal((session.send(*row), session.refused), (len(row), False))
            expected += [duty_of(text) for text in row]
            sent += len(row)
            if sent % 5 == 0:
                # The board counts too.
                equal(session.ask(), f"count({sent});")
            duties += carried_out(board)
        time.sleep(0.1)
        duties += carried_out(board)
        equal(duties, expected)
        return f"{sent} commands, frames sent again {session.repeated} times, each carried out once, in order, no other one"
    on_a_damaged_line(2, run)


def commands_and_requests_pass_at_every_pace_of_the_loop():
    with Board("Stall") as board:
        board.line.ready()
        session, counted = Session(board.line, patience=2.5), 0
        for pace in (0, 2, 5, 20, 150, 300):
            session.send(f"stall({pace})")
            begin = float(board.command("time"))
            rounds = 20 if pace < 100 else 5
            for _ in range(rounds):
                equal((session.send(0, "count", 0, 0), session.refused), (4, False))
                counted += 4
                equal(session.ask("(count)"), f"count({counted});")
            took = (float(board.command("time")) - begin) / rounds
            figure(f"loop() of {pace} ms: four commands and a request, one after the other's answer, {took:.0f} ms")
        equal(session.repeated, 0)


def reads_as_an_intact_stream(data):
    """Returns true if a damaged size swallows exactly the bytes of the following frames; no receiver could know."""
    decoder = version1.Decoder()
    decoder.receive(data, 0)
    decoder.idle(101)
    return b"getPercepts" not in decoder.messages or b"\xa5" in data[:6]


def version_1_carries_out_no_action_of_wrong_length_on_a_damaged_line():
    def run(board, actions, end):
        sent = damaged = carried = wrong_length = other = answered = swallowed = lost = 0
        intact = []
        request = frame1(b"getPercepts")
        damage, board.line.damage = board.line.damage, lambda data: data
        while time.monotonic() < end or sent <= LEAST:
            text = next(actions)
            frame = frame1(text.encode())
            arrives = damage(frame)
            sent += 1
            damaged += arrives != frame
            # The request that follows at once is intact: the board has to be back in step.
            board.line.write(arrives + request)
            is_swallowed = reads_as_an_intact_stream(arrives + request)
            answer = board.line.answer_bytes(3.0 if is_swallowed else PATIENCE)
            if answer:
                answered += 1
            elif is_swallowed:
                swallowed += 1
            else:
                lost += 1
                figure(f"not answered: {arrives + request}")
            comes = damage(answer)
            board.line.decoder1.receive(comes, time.monotonic() * 1000)
            if answer and comes == answer:
                intact.append(answer[6:])
            for act in carried_out(board):
                carried += 1
                lengths = {len(t) for t in ("led", "ledOn", "stop", "speed(%s)" % act[4:]) if duty_of(t) == act}
                wrong_length += len(text) not in lengths
                other += act != duty_of(text)
        # An answer that follows a damaged one at once may be read only when the line has been silent.
        board.line.decoder1.idle(time.monotonic() * 1000 + 101)
        read = set(board.line.decoder1.messages)
        unread = sum(answer not in read for answer in intact)
        equal((wrong_length, lost, unread), (0, 0, 0))
        return (f"{sent} actions sent, {damaged} damaged, {carried} carried out, {other} other than sent,"
                f" {wrong_length} of wrong length; {answered} of {sent} requests right behind them answered,"
                f" all {len(intact)} intact answers read")
    on_a_damaged_line(1, run)


CASES = [
    an_led_follows_actions_in_both_versions,
    a_command_and_a_request_in_one_burst_are_both_handled,
    a_repeated_command_is_carried_out_once,
    a_program_of_version_1_is_understood_behind_one_of_version_2,
    analogue_inputs_become_percepts,
    a_greenhouse_shows_its_sensors_and_switches_its_devices,
    motors_stop_when_the_far_end_falls_silent,
    motors_stop_when_the_far_end_closes_the_line,
    a_reflex_is_carried_out_by_the_board_itself,
    opening_the_line_resets_the_board_and_readiness_is_an_answer,
    messages_of_255_bytes_go_both_ways,
    sketches_for_earlier_libraries_run,
    the_distance_of_a_sonar_is_a_percept,
    a_servo_is_sent_pulses_of_the_angle_that_it_goes_to,
    a_pressed_button_is_reported_unasked,
    the_agents_line_may_be_on_two_other_pins,
    two_computers_have_a_conversation_each,
    another_rate_is_heard_as_on_a_wire,
    what_the_simulator_does_not_understand_is_refused,
    no_frame_is_lost_while_the_loop_stalls,
    a_slow_command_is_carried_out_once,
    an_outcome_is_reported_later_and_the_board_goes_on,
    reading_again_takes_a_bounded_time,
    a_burst_arrives_whole,
    requests_that_the_line_has_time_for_are_answered,
    version_2_asks_more_often_than_version_1_could,
    commands_and_requests_pass_at_every_pace_of_the_loop,
    version_2_carries_out_every_command_once_on_a_damaged_line,
    version_1_carries_out_no_action_of_wrong_length_on_a_damaged_line,
]


# The cases whose time is the program's, and not that of a UART and a processor, which QEMU does not time.
MACHINE_CASES = [
    an_led_follows_actions_in_both_versions,
    a_command_and_a_request_in_one_burst_are_both_handled,
    a_repeated_command_is_carried_out_once,
    a_program_of_version_1_is_understood_behind_one_of_version_2,
    analogue_inputs_become_percepts,
    a_robot_without_arduino_does_the_same,
    motors_stop_when_the_far_end_falls_silent,
    motors_stop_when_the_far_end_closes_the_line,
    a_reflex_is_carried_out_by_the_board_itself,
    messages_of_255_bytes_go_both_ways,
    a_slow_command_is_carried_out_once,
    an_outcome_is_reported_later_and_the_board_goes_on,
    version_2_carries_out_every_command_once_on_a_damaged_line,
    version_1_carries_out_no_action_of_wrong_length_on_a_damaged_line,
]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--board", choices=["uno", *MACHINES], default="uno")
    parser.add_argument("--damaged", type=float, default=DAMAGED_SECONDS, metavar="SECONDS", help="on a damaged line, in each version")
    parser.add_argument("wanted", nargs="*", help="parts of cases' names")
    options = parser.parse_args()
    Board.kind, Board.damaged_seconds = options.board, options.damaged
    wanted, failed = options.wanted, 0
    cases = [c for c in (CASES if options.board == "uno" else MACHINE_CASES) if not wanted or any(w in c.__name__ for w in wanted)]
    for case in cases:
        try:
            case()
            print(f"ok   {case.__name__.replace('_', ' ')}", flush=True)
        except AssertionError as failure:
            failed += 1
            print(f"FAIL {case.__name__.replace('_', ' ')}: {failure}", flush=True)
    print(f"{len(cases)} cases, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
