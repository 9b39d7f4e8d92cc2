"""The board's program for the vectors and the tests."""
import re

from . import vocabulary
from .board import DONE, LATER, REFUSES
from .rules import literal


class Program:
    """Carries out an action with the right number of arguments, unless its text is in `refuses` or `later`."""

    def __init__(self, actions=(), refuses=(), later=(), kinds=()):
        self.actions, self.refuses, self.later, self.kinds = list(actions), set(refuses), set(later), list(kinds)
        self.texts = []
        self.carried_out = []

    def percepts(self, functors):
        """Returns all texts, or those whose functors are in a list such as `(dist,light)`."""
        if not set(b"(,") & set(functors):
            return self.texts
        return [t for t in self.texts if re.search(rb"[(,]" + re.escape(literal(t)[0]) + rb"[,)]", functors)]

    def carry_out(self, text):
        name, arguments = literal(text)
        takes = next((n for action, n in reversed(self.actions) if action == name), None)
        if text in self.refuses or takes is None or takes not in (len(arguments), vocabulary.ANY_NUMBER):
            return REFUSES
        self.carried_out.append(text)
        return LATER if text in self.later else DONE
