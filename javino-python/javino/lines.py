"""Lines of microcontrollers: ports that the program has opened, and the USB port. `hosts` has the lines of computers."""
import sys

from .clock import ticks_diff, ticks_ms

IS_COMPUTER = sys.implementation.name == "cpython"


class LineGone(OSError):
    """The line is gone for good: a cable was unplugged, or the input has ended."""


def tell(text):
    """Warns the user of a computer, once for each text. A microcontroller prints nothing, because its output is the line."""
    if IS_COMPUTER:
        import warnings
        warnings.warn(text, RuntimeWarning, stacklevel=2)


def open_line(line, baud=None):
    """Returns a line for a name, an open port, or None. `hosts.open_named` explains names. `Board` explains None."""
    if line is not None and not isinstance(line, str):
        return line if hasattr(line, "wait") else Port(line)
    if IS_COMPUTER:
        from .hosts import open_named
        return open_named(line or "-", baud)
    if line is not None:
        raise ValueError("a microcontroller has no line %r; hand over the open port, as machine.UART(0, 9600), or nothing for USB" % line)
    return Console()


def _wait(is_ready, ms):
    """Waits at most `ms` milliseconds until `is_ready` returns true. Calls `is_ready` every millisecond."""
    try:
        from time import sleep_ms
    except ImportError:
        from time import sleep

        def sleep_ms(ms):
            sleep(ms / 1000)
    begin = ticks_ms()
    while not is_ready() and ticks_diff(ticks_ms(), begin) < ms:
        sleep_ms(1)


class Port:
    """A line on an open port: `machine.UART`, `busio.UART`, a pyserial port, or an object with equivalent `read` and `write`."""

    def __init__(self, port):
        self._port = port
        if hasattr(port, "in_waiting"):
            self._count = lambda: port.in_waiting
        elif hasattr(port, "any"):
            self._count = port.any
        else:
            raise TypeError("%r is no line: a port has read, write, and any or in_waiting; a line of your own read, write and wait" % port)

    def read(self):
        """Returns the bytes that have arrived, without waiting."""
        count = self._count()
        return self._port.read(count) if count else b""

    def write(self, data):
        """Writes all bytes."""
        while data:
            written = self._port.write(data)
            if written is None or written >= len(data):
                return
            data = data[written:]

    def wait(self, ms):
        """Waits until something has arrived, at most `ms` milliseconds."""
        _wait(self._count, ms)


class Console:
    """Standard input and output of a microcontroller: its USB port. The byte 03 is data, and does not interrupt the program."""

    def __init__(self):
        try:
            import micropython
            micropython.kbd_intr(-1)
        except (ImportError, AttributeError):
            pass
        self._in = getattr(sys.stdin, "buffer", sys.stdin)
        self._out = getattr(sys.stdout, "buffer", sys.stdout)
        try:
            import select
            self._poll = select.poll()
            self._poll.register(self._in, select.POLLIN)
        except (ImportError, AttributeError):  # CircuitPython
            import supervisor
            self._poll = None
            self._runtime = supervisor.runtime

    def _is_ready(self, ms):
        if self._poll:
            return bool(self._poll.poll(ms))
        return self._runtime.serial_bytes_available

    def read(self):
        """Returns the bytes that have arrived, without waiting."""
        data = bytearray()
        while len(data) < 256 and self._is_ready(0):
            byte = self._in.read(1)
            if not byte:
                if data:
                    break
                raise LineGone("the input has ended")
            data.extend(byte if isinstance(byte, bytes) else byte.encode())
        return bytes(data)

    def write(self, data):
        """Writes all bytes."""
        self._out.write(data)

    def wait(self, ms):
        """Waits until something has arrived, at most `ms` milliseconds."""
        if self._poll:
            self._is_ready(ms)
        else:
            _wait(lambda: self._is_ready(0), ms)
