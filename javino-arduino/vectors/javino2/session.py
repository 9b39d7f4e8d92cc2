"""The computer's side of a session: frames in, frames out. This module has no clock: the caller decides when to repeat frames."""
from . import vocabulary
from .frames import ACK, ASK, BUSY, CRITICAL, DESCRIBE, FLAGS, HELLO, LAST_PART, PART, PERCEPTS, REFUSED, VOCABULARY, WELCOME, Frame
from .parts import Assembly
from .percepts import Reader
from .window import Window

REVISION = 1


class Session:
    """`next_nonce` makes a nonce from the last one. The session adds results to four lists: `outcomes` (command, outcome), `answers`
    (request, texts; None if void), `critical` (payloads) and `pages` of the vocabulary. The caller takes the results from these
    lists."""

    def __init__(self, next_nonce, numbers=256, size=16, impossible=16):
        self.next_nonce, self.numbers, self.size = next_nonce, numbers, size
        self.impossible = impossible  # number of impossible numbers in a row that ends a session
        self.other_revision = None  # the revision of a board that speaks another revision
        self.nonce = 0
        self.outcomes, self.answers, self.critical, self.pages = [], [], [], []
        self.window = Window(numbers, size)
        self._close()

    def _close(self):
        self.open = False
        self.outcomes += self.window.give_up()
        self.nonce = self.next_nonce(self.nonce)
        self.welcome = b""

    def _open(self, welcome):
        self.open = True
        self.welcome = welcome
        self.window = Window(self.numbers, self.size)
        self.reader, self.assembly = Reader(), Assembly()
        self.requests, self.asked = 0, []
        self.impossible_numbers = 0

    def hello(self):
        return Frame(HELLO, self.nonce)

    def give_up(self):
        """Ends the session. Returns the frame that begins the next session."""
        self._close()
        return self.hello()

    def ask(self, functors=b""):
        self.requests = self.requests % 255 + 1
        self.asked.append(self.requests)
        return Frame(ASK, self.requests, bytes([self.reader.known()]) + functors)

    def repeat(self):
        """Returns the frame to send if an answer has not come in time, or None."""
        if not self.open:
            return self.hello()
        return self.window.repetition() if self.window.out else None

    def receive(self, frame, repeated_lately):
        """Returns the frames to send at once after a frame arrives."""
        kind = frame.kind & ~FLAGS
        if kind == WELCOME:
            return [] if self._welcomed(frame) else [self.hello()]
        if not self.open:
            return []
        busy = bool(frame.kind & BUSY)
        news = self.window.heard(frame.number, bool(frame.kind & REFUSED), busy)
        self.outcomes += news.outcomes
        self.impossible_numbers = 0 if news.accepted else self.impossible_numbers + 1
        if self.impossible_numbers == self.impossible:
            return [self.give_up()]
        if kind in (PERCEPTS, PART, LAST_PART):
            self._part(kind, frame.payload)
        elif kind == CRITICAL:
            self.critical.append(frame.payload)
        elif kind == VOCABULARY:
            self.pages.append(vocabulary.read_page(frame.payload))
        without_news = kind == ACK and news.accepted and not news.outcomes and not busy and not repeated_lately
        return [self.window.repetition()] if self.window.out and (news.again or without_news) else []

    def _welcomed(self, frame):
        """Takes a WELCOME. Returns true if the WELCOME opens the session or changes nothing. Returns false if the WELCOME ends the
        session."""
        nonce, revision = frame.payload[:1], (frame.payload[4:5] or b"\0")[0]
        is_own = nonce == bytes([self.nonce])
        if is_own == self.open:
            return True
        if is_own and revision != REVISION:
            self.other_revision = revision
            return True
        if is_own and not frame.number and not frame.kind & FLAGS:
            self._open(frame.payload)
            return True
        # The board has restarted, or another computer's session has an equal nonce.
        self._close()
        return False

    def _part(self, kind, payload):
        answer = self.assembly.take(kind, payload)
        if answer is None:
            return
        request, items = answer
        if request and request not in self.asked:
            return
        self.asked = [r for r in self.asked if r != request]
        self.answers.append((request, self.reader.read(items)))
