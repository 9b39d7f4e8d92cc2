"""The texts of literals: arriving actions, and percepts of the program. Texts are `str` with characters of ISO 8859-1, one character a
byte."""

_OPENING = "([{"
_CLOSING = ")]}"


def to_bytes(text):
    """Returns the text's bytes. Raises ValueError for a character that is not in ISO 8859-1."""
    data = text.encode()
    if len(data) == len(text):
        return data
    for character in text:
        if ord(character) > 255:
            raise ValueError("%r holds %r, and a message has only characters of ISO 8859-1" % (text, character))
    return bytes([ord(character) for character in text])


def to_text(data):
    """Returns the bytes as text."""
    for byte in data:
        if byte > 127:
            return "".join([chr(b) for b in data])
    return bytes(data).decode()


def functor_of(text):
    """Returns the part of the text before arguments and annotations."""
    for i in range(len(text)):
        if text[i] in "([;":
            return text[:i].strip(" ")
    return text.strip(" ")


def split(text):
    """Returns (functor, arguments, is_whole). Arguments are texts without surrounding blanks. `is_whole` is false if the text is no
    literal: a bracket, a quote or an argument is missing, or text follows the literal."""
    functor = functor_of(text)
    i = 0
    while i < len(text) and text[i] not in "([;":
        i += 1
    arguments, nesting, quote, escaped = [], "", "", False
    begin = i + 1
    is_whole = bool(functor)
    for c in functor:
        if c in "'\"{)]}, ":
            is_whole = False
    is_open = i < len(text) and text[i] == "("
    if i < len(text) and text[i] == ";":
        return functor, [], is_whole and not text[i + 1:].strip(" ")
    while i < len(text):
        c = text[i]
        if quote:
            if escaped:
                escaped = False
            elif c == "\\" and quote == '"':
                escaped = True
            elif c == quote:
                quote = ""
        elif c in "\"'":
            quote = c
        elif c in _OPENING:
            nesting += c
        elif c in _CLOSING:
            if not nesting or _OPENING.find(nesting[-1]) != _CLOSING.find(c):
                is_whole = False
            nesting = nesting[:-1]
        if is_open and not quote and (not nesting or nesting == "(" and c == ","):
            arguments.append(text[begin:i].strip(" "))
            begin = i + 1
            is_open = bool(nesting)
        elif not nesting and not quote and c not in " ;]":
            is_whole = False
        i += 1
    return functor, arguments, is_whole and not nesting and not quote and "" not in arguments


# ---- numbers ----


def _digits(text, at):
    while at < len(text) and "0" <= text[at] <= "9":
        at += 1
    return at


def is_number(text):
    """Returns true if the text is a number: an optional sign, digits, and optionally a point and digits."""
    begin = 1 if text[:1] in ("+", "-") and text else 0
    point = _digits(text, begin)
    if point == begin or point == len(text):
        return point > begin
    return text[point] == "." and _digits(text, point + 1) == len(text) > point + 1


def _scaled(text, places):
    negative = text[0] == "-"
    if text[0] in "+-":
        text = text[1:]
    point = text.find(".")
    if point >= 0:
        places -= len(text) - point - 1
        text = text[:point] + text[point + 1:]
    number = int(text + "0" * places)
    return -number if negative else number


def compare(a, b):
    """Compares two numbers, given as texts. Returns a negative number if `a < b`, 0 if they are equal, else a positive number. The
    comparison is exact, unlike with a microcontroller's floats."""
    places = len(a) + len(b)
    a, b = _scaled(a, places), _scaled(b, places)
    return (a > b) - (a < b)


# ---- Python's values ----


def value(argument):
    """Returns the value of an action's argument: an int, a float, or a str without its quotes. Returns lists and structures as texts."""
    if is_number(argument):
        return float(argument) if "." in argument else int(argument)
    if argument[0] == '"' or argument[0] == "'":
        return _unquoted(argument)
    exponent = max(argument.find("e"), argument.find("E"))
    if exponent > 0 and is_number(argument[:exponent]) and is_number(argument[exponent + 1:]) and "." not in argument[exponent:]:
        return float(argument)
    return argument


def _unquoted(text):
    inner = text[1:-1]
    if text[0] == "'" or "\\" not in inner:
        return inner
    unquoted, i = "", 0
    while i < len(inner):
        if inner[i] == "\\":
            i += 1
            unquoted += {"n": "\n", "t": "\t", "r": "\r"}.get(inner[i], inner[i])
        else:
            unquoted += inner[i]
        i += 1
    return unquoted


def term(value):
    """Returns the text of a Python value in a percept: of a number, True, False, a list or a str. A str becomes an atom if possible,
    else a string. Raises ValueError for a float that is infinite or NaN, and TypeError for other values."""
    if value is True or value is False:
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        if value != value or value - value != 0:
            raise ValueError("a percept cannot hold %r; leave it out, or send another value" % value)
        return repr(value)
    if isinstance(value, str):
        return value if _is_atom(value) else _quoted(value)
    if isinstance(value, (list, tuple)):
        return "[" + ",".join([term(each) for each in value]) + "]"
    raise TypeError("a percept holds numbers, texts, True, False and lists of them, not %r" % (value,))


def _is_atom(text):
    if not text or not "a" <= text[0] <= "z" or text in ("not", "div", "mod"):
        return False
    for c in text:
        if not ("a" <= c <= "z" or "A" <= c <= "Z" or "0" <= c <= "9" or c == "_"):
            return False
    return True


def _quoted(text):
    for c, escape in (("\\", "\\\\"), ('"', '\\"'), ("\n", "\\n"), ("\r", "\\r"), ("\t", "\\t")):
        text = text.replace(c, escape)
    return '"' + text + '"'
