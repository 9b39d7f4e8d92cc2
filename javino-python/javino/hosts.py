"""Lines of computers, by name. Linux and macOS need only Python. On Windows serial ports need pyserial."""
import os
import select
import socket
import sys
import time

from .lines import LineGone, Port

_CREDIT = 255  # the system's own buffer is larger
_PATIENCE = 1.0  # seconds after which bytes that nobody takes are dropped, as on a serial line


def open_named(name, baud=None):
    """Opens a line by its name and returns it.

    `/dev/ttyGS0` or `COM3` is a serial port. `pty` is a pseudo-terminal. The line's `name` is then the device that a computer
    opens. `pty:/tmp/board` also makes a link to that device. `tcp://HOST:PORT` listens there, for one computer at a time. `-` is
    standard input and output.

    Raises ValueError for any other name. Raises OSError with the system's reason if the line cannot be opened.
    """
    if name == "-":
        return Descriptor(sys.stdin.fileno(), sys.stdout.fileno(), "standard input and output")
    if name == "pty" or name.startswith("pty:"):
        return PseudoTerminal(name[4:])
    if name.startswith("tcp:"):
        return Listener(name, *_address(name))
    if ":" in name:
        raise ValueError(f'"{name}" names no line; there are /dev/ttyGS0, COM3, pty, pty:PATH, tcp://HOST:PORT and -')
    return _serial(name, baud or 9600)


def _address(name):
    host, _, number = name[4:].lstrip("/").rstrip("/").rpartition(":")
    host = host.strip("[]")
    if not host or not number.isdigit() or not 0 <= int(number) <= 65535:
        raise ValueError(f'"{name}" names no line: it is tcp://HOST:PORT, as tcp://127.0.0.1:4000, or tcp://0.0.0.0:4000 for all networks')
    return host, int(number)


def _serial(name, baud):
    if os.name == "nt":
        return _pyserial(name, baud)
    import termios
    import tty
    path = name if "/" in name else "/dev/" + name
    rate = getattr(termios, f"B{baud}", None)
    if rate is None:
        return _pyserial(path, baud)
    fd = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    try:
        tty.setraw(fd)
        settings = termios.tcgetattr(fd)
        settings[2] |= termios.CLOCAL | termios.CREAD
        settings[4] = settings[5] = rate
        termios.tcsetattr(fd, termios.TCSANOW, settings)
    except termios.error as e:
        os.close(fd)
        raise OSError(f"{path} is no serial port: {e.args[1]}") from e
    return Descriptor(fd, fd, path)


def _pyserial(name, baud):
    try:
        import serial
    except ImportError as e:
        raise OSError(f'{name} at {baud} baud needs pyserial: "pip install pyserial"') from e
    return Port(serial.Serial(name, baud, timeout=0))


def _write_all(send, target, data):
    """Writes all bytes with `send`. Waits while `target` takes no bytes. If `target` takes none for a second, drops the rest and
    returns false."""
    end = time.monotonic() + _PATIENCE
    while data:
        try:
            data = data[send(data):]
        except BlockingIOError:
            if not select.select([], [target], [], max(0.0, end - time.monotonic()))[1]:
                return False
    return True


class Descriptor:
    """A line on two file descriptors, or on one file descriptor for both directions."""

    credit = _CREDIT

    def __init__(self, fd_in, fd_out, name):
        self.name = name
        self._in, self._out = fd_in, fd_out
        os.set_blocking(fd_in, False)
        os.set_blocking(fd_out, False)

    def read(self):
        """Returns the bytes that have arrived, without waiting. Raises LineGone at the end of the input."""
        try:
            data = os.read(self._in, 4096)
        except BlockingIOError:
            return b""
        except OSError as e:
            raise LineGone(f"{self.name} is gone: {e.strerror}") from e
        if not data:
            raise LineGone(f"{self.name} has ended")
        return data

    def write(self, data):
        """Writes all bytes. If the far end takes no byte for a second, drops the rest."""
        try:
            _write_all(lambda rest: os.write(self._out, rest), self._out, data)
        except OSError as e:
            raise LineGone(f"{self.name} is gone: {e.strerror}") from e

    def wait(self, ms):
        """Waits until something has arrived, at most `ms` milliseconds."""
        select.select([self._in], [], [], ms / 1000)

    def close(self):
        """Closes the line."""
        os.close(self._in)
        if self._out != self._in:
            os.close(self._out)


class PseudoTerminal(Descriptor):
    """A pseudo-terminal. `name` is the device that a computer opens. The terminal keeps its settings and bytes until `close`."""

    def __init__(self, link=""):
        import tty
        master, self._slave = os.openpty()
        tty.setraw(self._slave)
        super().__init__(master, master, os.ttyname(self._slave))
        self._link = link
        if link:
            if os.path.islink(link):
                os.unlink(link)
            os.symlink(self.name, link)

    def close(self):
        """Removes the terminal and the link."""
        super().close()
        os.close(self._slave)
        if self._link and os.path.islink(self._link) and os.readlink(self._link) == self.name:
            os.unlink(self._link)


class Listener:
    """A line that listens for computers. The line serves the computer that connected last."""

    credit = _CREDIT

    def __init__(self, name, host, number):
        self._server = socket.create_server((host, number), family=socket.AF_INET6 if ":" in host else socket.AF_INET)
        self._server.setblocking(False)
        self.name = f"tcp://{f'[{host}]' if ':' in host else host}:{self._server.getsockname()[1]}"
        self._connection = None

    def _accept(self):
        try:
            connection = self._server.accept()[0]
        except BlockingIOError:
            return
        connection.setblocking(False)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._leave()
        self._connection = connection

    def _leave(self):
        if self._connection:
            self._connection.close()
            self._connection = None

    def read(self):
        """Returns the bytes that have arrived, without waiting."""
        self._accept()
        if not self._connection:
            return b""
        try:
            data = self._connection.recv(4096)
        except BlockingIOError:
            return b""
        except OSError:
            data = b""
        if not data:
            self._leave()
        return data

    def write(self, data):
        """Writes all bytes. If the far end has gone or takes no byte for a second, drops the rest and the connection."""
        if not self._connection:
            return
        try:
            is_written = _write_all(self._connection.send, self._connection, data)
        except OSError:
            is_written = False
        if not is_written:
            self._leave()

    def wait(self, ms):
        """Waits until something has arrived, at most `ms` milliseconds."""
        select.select([self._server] + ([self._connection] if self._connection else []), [], [], ms / 1000)

    def close(self):
        """Ends the connection and stops listening."""
        self._leave()
        self._server.close()
