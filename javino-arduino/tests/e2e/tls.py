#!/usr/bin/env python3
"""The example TlsRobot with mbedTLS as a program on this machine: tls.py FOLDER, which has the program and certificates."""
import contextlib
import pathlib
import select
import socket
import ssl
import subprocess
import sys
import threading
import time

from board import PATIENCE, FarEnd, Session, frame1
from cases import check, equal

FOLDER = pathlib.Path(sys.argv[1])


class Robot:
    """The board; use it in a with statement."""

    def __enter__(self):
        self.process = subprocess.Popen([FOLDER / "board"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.port = int(self.process.stdout.readline().split()[1])
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        if self.process.wait(PATIENCE) != 0:
            raise AssertionError("the board has failed")
        self.process.stdout.close()

    def motor(self):
        """Returns the motor's power after its next change."""
        check(select.select([self.process.stdout], [], [], PATIENCE)[0], "the motor did not change")
        return int(self.process.stdout.readline().split()[1])

    def connect(self):
        return socket.create_connection(("127.0.0.1", self.port), PATIENCE)

    def tls(self, who, board="robot"):
        """Opens a connection with this certificate, None for none, that accepts only this board."""
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
        context.check_hostname = False
        context.load_verify_locations(FOLDER / f"{board}.crt")
        if who:
            context.load_cert_chain(FOLDER / f"{who}.crt", FOLDER / f"{who}.key")
        return context.wrap_socket(self.connect())


@contextlib.contextmanager
def line(connection):
    """The far end of a line over this connection."""
    near, far = socket.socketpair()

    def relay():
        with contextlib.suppress(OSError):
            while True:
                ready = [connection] if connection.pending() else select.select([connection, near], [], [])[0]
                for source, sink in ((connection, near), (near, connection)):
                    if source in ready:
                        data = source.recv(4096)
                        if not data:
                            near.close()
                            return
                        sink.sendall(data)
    thread = threading.Thread(target=relay)
    thread.start()
    end = FarEnd(far.detach())
    try:
        yield end
    finally:
        end.close()
        thread.join(PATIENCE)
        connection.close()


def is_cut(connection):
    """Returns true if the board ends this connection, without an answer."""
    try:
        connection.settimeout(PATIENCE)
        connection.sendall(frame1(b"getPercepts"))
        return connection.recv(100) == b""
    except (ssl.SSLError, ConnectionError):
        return True


def the_owner_drives_the_robot_and_it_stops_without_him():
    with Robot() as robot, line(robot.tls("computer")) as far:
        far.ready()
        session = Session(far)
        equal((session.send("speed(120)"), session.refused), (1, False))
        equal(robot.motor(), 120)
        equal(session.ask(), "motor(120);")
        equal(robot.motor(), 0)


def whoever_else_is_refused_and_disturbs_nobody():
    with Robot() as robot, line(robot.tls("computer")) as far:
        far.ready()
        session = Session(far)
        for who in ("stranger", None):
            try:
                check(is_cut(robot.tls(who)), f"with the certificate {who} it answers")
            except (ssl.SSLError, ConnectionError):
                pass  # refused within the handshake
        check(is_cut(robot.connect()), "it answers without TLS")
        robot.connect()  # says nothing, and stays
        equal(session.ask(), "motor(0);")
        equal((session.send("speed(7)"), session.refused), (1, False))
        equal(robot.motor(), 7)


def the_board_is_known_by_its_certificate():
    with Robot() as robot:
        try:
            robot.tls("computer", board="stranger")
            raise AssertionError("another board's certificate was taken for this one's")
        except ssl.SSLCertVerificationError:
            pass


def the_newest_connection_of_the_owner_counts():
    with Robot() as robot, robot.tls("computer") as first:
        first.sendall(frame1(b"getPercepts"))
        equal(first.recv(100), b"fffe09motor(0);")
        with line(robot.tls("computer")) as second:
            second.ready()
            equal(second.ask(), "motor(0);")
            check(is_cut(first), "the connection before is still answered")


def what_is_cut_off_in_the_handshake_leaves_the_board_as_it_was():
    with Robot() as robot:
        for length in (0, 1, 5, 40, 100):
            with robot.connect() as connection:
                connection.sendall(b"\x16\x03\x01\x02\x00\x01" + bytes(length))
        with line(robot.tls("computer")) as far:
            far.ready()
            begin = time.monotonic()
            for _ in range(100):
                far.ask()
            print(f"  TlsRobot on this machine: {100 / (time.monotonic() - begin):.0f} requests a second over TLS")


def main():
    failed = 0
    for case in (the_owner_drives_the_robot_and_it_stops_without_him, whoever_else_is_refused_and_disturbs_nobody,
                 the_board_is_known_by_its_certificate, the_newest_connection_of_the_owner_counts,
                 what_is_cut_off_in_the_handshake_leaves_the_board_as_it_was):
        try:
            case()
            print(f"ok   {case.__name__.replace('_', ' ')}", flush=True)
        except AssertionError as failure:
            failed += 1
            print(f"FAIL {case.__name__.replace('_', ' ')}: {failure}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
