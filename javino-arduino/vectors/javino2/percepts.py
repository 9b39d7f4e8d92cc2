"""Answers: percept texts as rows of items. A percept's first item holds its whole text. Later items hold only its digits."""
import re

MAX_SHAPES = 126
BY_NUMBER, CONTINUED, WITHOUT_ID = 0x80, 0x7E, 0x7F
MAX_TEXT = 255
END_OF_NUMBER = 0xF

_NUMBER = re.compile(rb"[0-9]+")


def shape(text):
    """Returns the text without its digits: the pieces before, between and after its numbers."""
    return tuple(_NUMBER.split(text))


def half_bytes(text):
    """Returns the digits of the text's numbers, with an F after each number."""
    return [h for number in _NUMBER.findall(text) for h in [d - 0x30 for d in number] + [END_OF_NUMBER]]


def pack(halves):
    halves = halves + [END_OF_NUMBER] * (len(halves) % 2)
    return bytes(high << 4 | low for high, low in zip(halves[::2], halves[1::2]))


class Writer:
    """The board's table of shapes. Writes answers. Each session has its own writer."""

    def __init__(self, room=MAX_SHAPES):
        self.room = min(room, MAX_SHAPES)
        self.ids = {}

    def write(self, texts, known):
        """Returns the items of an answer. `known` is the number of texts that the computer knows, from its newest ASK. Joins consecutive
        ids into runs."""
        items, run = [], None  # run: [first id, count, half bytes]
        for text in texts:
            id = self._id(text)
            if id is not None and id < known:
                if run and run[0] + run[1] == id:
                    run[1] += 1
                    run[2] += half_bytes(text)
                else:
                    run = [id, 1, half_bytes(text)]
                    items.append(run)
            else:
                run = None
                items.append(self._text(text, id))
        return b"".join(i if isinstance(i, bytes) else bytes([BY_NUMBER + i[0], i[1]]) + pack(i[2]) for i in items)

    @classmethod
    def write_without_ids(cls, texts):
        """Returns the items of texts that take no ids, such as a description."""
        return b"".join(cls._text(text, None) for text in texts)

    def _id(self, text):
        if len(text) > MAX_TEXT:
            return None
        if shape(text) not in self.ids and len(self.ids) < self.room:
            self.ids[shape(text)] = len(self.ids)
        return self.ids.get(shape(text))

    @staticmethod
    def _text(text, id):
        begun = b""
        while len(text) > MAX_TEXT:
            begun += bytes([CONTINUED, MAX_TEXT]) + text[:MAX_TEXT]
            text = text[MAX_TEXT:]
        return begun + bytes([WITHOUT_ID if id is None else id, len(text)]) + text


class Void(Exception):
    """An item that cannot be read."""


class Reader:
    """The computer's table of shapes. Reads answers. Each session has its own reader."""

    def __init__(self):
        self.shapes = {}

    def known(self):
        """Returns the number of known ids, counted from 0 up to the first gap."""
        n = 0
        while n in self.shapes:
            n += 1
        return n

    def read(self, items):
        """Returns the texts of an answer. If the answer is void, returns None and forgets all ids."""
        try:
            return self._read(items)
        except Void:
            self.shapes = {}
            return None

    def _read(self, items):
        texts, begun = [], b""
        while items:
            if len(items) < 2:
                raise Void
            first, n, items = items[0], items[1], items[2:]
            if first >= BY_NUMBER:
                if begun or n == 0:
                    raise Void
                read, items = self._by_number(first - BY_NUMBER, n, items)
                texts += read
                continue
            if len(items) < n or begun and first < CONTINUED:
                raise Void
            text, items = items[:n], items[n:]
            if first == CONTINUED:
                begun += text
                continue
            if first < CONTINUED:
                self.shapes[first] = shape(text)
            texts.append(begun + text)
            begun = b""
        if begun:
            raise Void
        return texts

    def _by_number(self, first, count, items):
        halves = [h for byte in items for h in (byte >> 4, byte & 15)]
        at, texts = 0, []
        for id in range(first, first + count):
            if id not in self.shapes:
                raise Void
            pieces = self.shapes[id]
            text = pieces[0]
            for piece in pieces[1:]:
                begin = at
                while at < len(halves) and halves[at] < 10:
                    at += 1
                if at == begin or at == len(halves) or halves[at] != END_OF_NUMBER:
                    raise Void
                text += bytes(0x30 + h for h in halves[begin:at]) + piece
                at += 1
            texts.append(text)
        if at % 2 and halves[at] != END_OF_NUMBER:
            raise Void
        return texts, items[(at + 1) // 2:]
