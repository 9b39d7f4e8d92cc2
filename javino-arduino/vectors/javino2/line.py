"""What a board receives on a line that both versions share."""
import version1

from .frames import START, TO_BOARD, Receiver


class Line:
    """Finds frames of version 2, and of version 1 where they count; both are added to `received`, those of version 1 as bytes."""

    def __init__(self, timeout=100, longest=255):
        self.timeout = timeout
        self.session = False  # whether the board has one now
        self.version1 = version1.Decoder(timeout)
        self.version2 = Receiver(TO_BOARD, timeout, self._outside, longest)
        self.last = 0
        self.received = []

    def receive(self, data, now):
        for byte in data:
            self.version2.receive(bytes([byte]), now)
            self.received += self.version2.frames
            self.version2.frames.clear()
            self.last = now

    def idle(self, now):
        """Says that it is this late and that nothing else has arrived."""
        if not self.session:
            self.version1.idle(now)
            self._deliver()

    def _outside(self, byte, now):
        """Takes a byte outside of frames of version 2; returns whether version 1 has it."""
        if byte == START and not self.version1.in_payload():
            self.version1.forget()
            return False
        if self.session:
            self._in_session(byte, now)
        else:
            self.version1.receive(bytes([byte]), now)
            self._deliver()
        return True

    def _in_session(self, byte, now):
        """A frame of version 1 counts if its first byte follows a silence; nothing is read twice."""
        before = len(self.version1.window)
        if not before and now - self.last < self.timeout / 4:
            return
        self.version1.receive(bytes([byte]), now)
        if len(self.version1.window) == before + 1:
            self._deliver()
            if not self.version1.delivered:
                return
        self.version1.messages.clear()
        self.version1.forget()

    def _deliver(self):
        self.received += self.version1.messages
        self.version1.messages.clear()
