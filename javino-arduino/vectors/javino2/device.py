"""A whole board that speaks both versions: bytes in, bytes out."""
import version1

from .board import Board
from .frames import Frame, encode
from .line import Line

REQUEST = b"getPercepts"


class Device:
    def __init__(self, program, now, timeout=100, **board):
        self.program = program
        self.board = Board(program, **board)
        self.line = Line(self._take, timeout, self.board.longest, now)
        self.sending = b""

    def receive(self, data, now):
        """Returns the bytes that answer the received bytes, possibly none."""
        self.line.idle(now)
        self.line.receive(data, now)
        return self._sent()

    def report(self, outcome):
        return self._encoded(self.board.report(outcome))

    def percepts_unasked(self):
        return self._encoded(self.board.percepts_unasked())

    def _encoded(self, frames):
        return b"".join(encode(frame, self.board.session) for frame in frames)

    def _sent(self):
        sending, self.sending = self.sending, b""
        return sending

    def _take(self, message):
        if isinstance(message, Frame):
            self.sending += self._encoded(self.board.receive(message))
        else:
            self.sending += b"".join(map(version1.frame, self.message(message)))
        self.line.session = self.board.session

    def message(self, message):
        """Returns the messages of version 1 that answer a message of version 1."""
        self.board.end()
        if message[:len(REQUEST)] == REQUEST and message[len(REQUEST):len(REQUEST) + 1] in (b"", b"("):
            return [b"".join(self.program.percepts(message[len(REQUEST):]))]
        self.program.carry_out(message)
        return []
