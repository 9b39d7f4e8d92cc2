"""The receiver of a board, on a line with frames of both versions."""
import version1

from .frames import START, TO_BOARD, Receiver


class Line:
    """Finds frames of version 2, and valid frames of version 1. Passes each to `deliver`, as a Frame or as a payload of version 1.

    `session` is the nonce of the board's present session, or 0. Set `session` before the next byte comes, at the latest in `deliver`.
    """

    def __init__(self, deliver, timeout=100, longest=255, now=0):
        self.deliver = deliver
        self.timeout = timeout
        self.session = 0
        self.version1 = version1.Decoder(timeout, START, self._deliver1)
        self.version2 = Receiver(TO_BOARD, timeout, longest)
        self.last = now

    def receive(self, data, now):
        """Takes bytes that arrive together."""
        self.idle(now)
        for byte in data:
            self._put(byte)
            self.last = now

    def idle(self, now):
        """Call this if no byte has arrived up to this time."""
        silence = now - self.last
        if silence > self.timeout:
            while self.version1.window:
                self._again(self.version1.give_up())
            self.version2.body = None
        if silence > self.timeout / 4 and not self.version1.waits():
            self.version1.quiet = True

    def _put(self, byte):
        if self.version2.body is not None:
            self._put2(byte)
        else:
            self.version1.anywhere = not self.session
            self._again(self.version1.put(byte))

    def _deliver1(self, message):
        self.deliver(message)
        self.version1.anywhere = not self.session

    def _again(self, rest):
        """Takes bytes that version 1 did not use. The bytes begin with a frame of version 2."""
        if rest:
            self._put2(rest[0])
        for byte in rest[1:]:
            self._put(byte)

    def _put2(self, byte):
        self.version2.nonce = self.session
        self.version2.receive(bytes([byte]), self.version2.last)
        frames, self.version2.frames = self.version2.frames, []
        for frame in frames:
            self.deliver(frame)
        self.version1.quiet = self.version1.anywhere = not self.session
