"""A program for a board, as the vectors and the tests describe it."""
from . import vocabulary
from .board import DONE, LATER, REFUSES
from .rules import literal


class Program:
    """Carries out what is an action with the right number of arguments, unless its text is in `refuses` or `later`."""

    def __init__(self, actions=(), refuses=(), later=()):
        self.actions, self.refuses, self.later = list(actions), set(refuses), set(later)
        self.texts = []
        self.carried_out = []

    def percepts(self, functors):
        """All texts, or those of the functors in `(dist,light)`."""
        wanted = functors.strip(b"()").split(b",") if functors else None
        return [t for t in self.texts if wanted is None or literal(t)[0] in wanted]

    def carry_out(self, text):
        name, arguments = literal(text)
        takes = next((n for action, n in reversed(self.actions) if action == name), None)
        if text in self.refuses or takes is None or takes not in (len(arguments), vocabulary.ANY_NUMBER):
            return REFUSES
        self.carried_out.append(text)
        return LATER if text in self.later else DONE
