"""Answers of version 2: percepts as a list of items. The first text of a shape goes out whole. Later percepts with this shape go out
as digits."""

MAX_SHAPES = 126
_BY_NUMBER = 0x80
_CONTINUED = 0x7E
_WITHOUT_ID = 0x7F
_MAX_TEXT = 255
_END_OF_NUMBER = 0xF


def _shape(text, halves):
    """Returns the text with one 0 in place of each run of digits. Appends the digits to `halves` as half bytes, with an F after each
    run."""
    shape = bytearray()
    was_digit = False
    for byte in text:
        is_digit = 0x30 <= byte <= 0x39
        if is_digit:
            halves.append(byte - 0x30)
        elif was_digit:
            halves.append(_END_OF_NUMBER)
        if not (is_digit and was_digit):
            shape.append(0x30 if is_digit else byte)
        was_digit = is_digit
    if was_digit:
        halves.append(_END_OF_NUMBER)
    return bytes(shape)


class Shapes:
    """A session's table of sent shapes. Writes answers."""

    def __init__(self, room=MAX_SHAPES):
        self._room = min(room, MAX_SHAPES)
        self._ids = {}

    def __len__(self):
        return len(self._ids)

    def write(self, texts, known):
        """Returns the items of an answer. `known` is the number of shapes that the computer knew at its request."""
        items = bytearray()
        first, count, halves = 0, 0, bytearray()  # a row of percepts with consecutive ids, sent as digits
        for text in texts:
            digits = bytearray()
            id = self._id(text, digits)
            if id >= known:
                self._end_row(items, first, count, halves)
                count = 0
                self._write_text(items, text, id)
                continue
            if not count or id != first + count:
                self._end_row(items, first, count, halves)
                first, count, halves = id, 0, bytearray()
            count += 1
            halves.extend(digits)
        self._end_row(items, first, count, halves)
        return bytes(items)

    @classmethod
    def write_without_ids(cls, texts):
        """Returns the items of texts that get no ids, such as a description."""
        items = bytearray()
        for text in texts:
            cls._write_text(items, text, _WITHOUT_ID)
        return bytes(items)

    def _id(self, text, digits):
        """Returns the id of the text's shape, or _WITHOUT_ID."""
        if len(text) > _MAX_TEXT:
            return _WITHOUT_ID
        shape = _shape(text, digits)
        id = self._ids.get(shape)
        if id is None:
            id = len(self._ids)
            if id >= self._room:
                return _WITHOUT_ID
            self._ids[shape] = id
        return id

    @staticmethod
    def _end_row(items, first, count, halves):
        if not count:
            return
        items.append(_BY_NUMBER + first)
        items.append(count)
        if len(halves) & 1:
            halves.append(_END_OF_NUMBER)
        for i in range(0, len(halves), 2):
            items.append(halves[i] << 4 | halves[i + 1])

    @staticmethod
    def _write_text(items, text, id):
        while len(text) > _MAX_TEXT:
            items.extend(bytes((_CONTINUED, _MAX_TEXT)))
            items.extend(text[:_MAX_TEXT])
            text = text[_MAX_TEXT:]
        items.append(id)
        items.append(len(text))
        items.extend(text)
