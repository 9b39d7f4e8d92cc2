"""Defects of the two state machines, each of which the model must find; they show the purpose of the protocol's rules."""
from contextlib import contextmanager
from unittest.mock import patch

from javino2.board import Board
from javino2.frames import COMMANDS_RESUME, FLAGS, HELLO, PERCEPTS, REFUSED
from javino2.parts import Assembly
from javino2.percepts import Writer
from javino2.session import Session
from javino2.window import Window


def replaced(owner, name, function):
    """A defect: `function` in place of a method, with the method as its first argument."""
    original = getattr(owner, name)
    return patch.object(owner, name, lambda *arguments: function(original, *arguments))


def resume_any(original, self, frame):
    if frame.kind == COMMANDS_RESUME:
        self.refused = False
    original(self, frame)


def resume_at_once(original, self, first, row):
    return original(self, first, row)._replace(kind=COMMANDS_RESUME)


def resume_once(original, self):
    frame = original(self)
    self.resume = False
    return frame


def begin_without(*kept):
    """HELLO that leaves these attributes of the board as they are."""
    def begin(original, self, nonce):
        values = {name: getattr(self, name) for name in kept if hasattr(self, name)}
        original(self, nonce)
        vars(self).update(values)
    return begin


def begins_anew(original, self, frame):
    if frame.kind == HELLO:
        self.session = 0
    return original(self, frame)


def no_refused_in_answers(original, self, kind, payload=b""):
    frame = original(self, kind, payload)
    return frame._replace(kind=frame.kind & ~REFUSED) if frame.kind & ~FLAGS == PERCEPTS else frame


def only_first_out_is_acknowledged(original, self, due, refused, busy):
    return original(self, due, refused and due == (self.oldest + 1) % self.numbers, busy)


def forgets_nothing(original, self, due, refused, busy):
    self.out = [entry._replace(as_nothing=False) for entry in self.out]
    return original(self, due, refused, busy)


def any_welcome(original, self, frame):
    return original(self, frame._replace(payload=bytes([self.nonce]) + frame.payload[1:]))


def any_part(original, self, kind, payload):
    if kind & ~FLAGS != PERCEPTS and payload[1] and self.request:
        self.request, self.parts = payload[0], payload[1]
    return original(self, kind, payload)


def digits_of_all(original, self, texts, known):
    return original(self, texts, max(known, len(self.ids)))


def texts_of_the_last_session(original, self, welcome):
    reader = getattr(self, "reader", None)
    original(self, welcome)
    self.reader, self.requests = reader or self.reader, 1 if reader else 0


@contextmanager
def wide_window():
    with patch("model.WINDOW", 4):
        yield


MUTATIONS = [
    ("the board ignores the number of RESUME", replaced(Board, "_commands", resume_any)),
    ("the board does not look at what is due", patch.object(Board, "_is_next", lambda self, n: not self.refused and not self.busy)),
    ("the board jumps gaps", patch.object(Board, "_is_next", lambda s, n: (n - s.due) % s.numbers < 2 and not s.refused and not s.busy)),
    ("the board goes on behind a refusal", patch.object(Board, "_is_next", lambda self, n: n == self.due and not self.busy)),
    ("HELLO that comes twice begins anew", replaced(Board, "receive", begins_anew)),
    ("frames are the same in all sessions", patch("model.begins_sessions", lambda kind: True)),
    ("the board goes on while an outcome is open", patch.object(Board, "_is_next", lambda self, n: n == self.due and not self.refused)),
    ("HELLO leaves due as it is", replaced(Board, "_begin", begin_without("due"))),
    ("HELLO leaves REFUSED as it is", replaced(Board, "_begin", begin_without("refused"))),
    ("HELLO leaves BUSY as it is", replaced(Board, "_begin", begin_without("busy"))),
    ("the board sends digits of all that it ever sent as text", replaced(Writer, "write", digits_of_all)),
    ("answers do not say REFUSED", replaced(Board, "_say", no_refused_in_answers)),
    ("the computer accepts any number", patch.object(Window, "accepts", lambda self, count: True)),
    ("a command that went out as FE is done when it is acknowledged", replaced(Window, "heard", forgets_nothing)),
    ("a command whose time is over is repeated", patch.object(Window, "time_over", lambda self, command: None)),
    ("RESUME in every frame", replaced(Window, "_frame", resume_at_once)),
    ("RESUME is not repeated", replaced(Window, "repetition", resume_once)),
    ("REFUSED counts for the first command alone", replaced(Window, "heard", only_first_out_is_acknowledged)),
    ("any WELCOME is the right one", replaced(Session, "_welcomed", any_welcome)),
    ("a session is opened with the nonce of the last", patch("model.next_nonce", lambda last: 1)),
    ("a window as large as there are numbers", wide_window()),
    ("parts are put together in the order in which they come", replaced(Assembly, "take", any_part)),
    ("the computer keeps the texts of the last session", replaced(Session, "_open", texts_of_the_last_session)),
]
