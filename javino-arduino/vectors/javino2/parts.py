"""Answers in parts."""
from .frames import FLAGS, LAST_PART, PART, PERCEPTS

MAX_PARTS = 255


def split(request, answer, size=None):
    """Returns the frames of an answer as (kind, payload). Each part holds `size` bytes of the answer, or as many as a frame holds."""
    if len(answer) <= (size or 254):
        return [(PERCEPTS, bytes([request]) + answer)]
    size = size or 253
    pieces = [answer[i:i + size] for i in range(0, len(answer), size)]
    if len(pieces) > MAX_PARTS:
        raise ValueError(f"an answer has at most {MAX_PARTS} parts, this one {len(pieces)}")
    last = len(pieces) - 1
    return [(PART if i < last else LAST_PART, bytes([request, i]) + piece) for i, piece in enumerate(pieces)]


class Assembly:
    """Joins parts. If a part is missing, the answer is void."""

    def __init__(self):
        self.request, self.parts, self.answer = None, 0, b""

    def take(self, kind, payload):
        """Returns (request, answer) if this frame completes an answer, else None."""
        kind &= ~FLAGS
        if len(payload) < (1 if kind == PERCEPTS else 2):
            return None
        if kind == PERCEPTS:
            self.request = None
            return payload[0], payload[1:]
        request, part, piece = payload[0], payload[1], payload[2:]
        if part == 0:
            self.request, self.parts, self.answer = request, 0, b""
        if request != self.request or part != self.parts:
            self.request = None
            return None
        self.parts += 1
        self.answer += piece
        if kind == PART:
            return None
        self.request = None
        return request, self.answer
