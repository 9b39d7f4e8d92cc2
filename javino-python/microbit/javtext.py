def term(value):
    if not isinstance(value, str):
        return str(value).lower()
    if value.replace("_", "a").isalpha() and value[0].islower():
        return value
    return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'


def value(text):
    if text[:1] == '"':
        return text[1:-1].replace('\\"', '"')
    for kind in (int, float):
        try:
            if text[-1:].isdigit():
                return kind(text)
        except ValueError:
            pass
    return text


def split(text):
    if text[-1:] != ")":
        return [text]
    begin = text.find("(") + 1
    parts, quoted = [text[:begin - 1]], False
    for i in range(begin, len(text)):
        c = text[i]
        if c == '"' and text[i - 1] != "\\":
            quoted = not quoted
        elif not quoted and c in ",)":
            parts.append(value(text[begin:i].strip()))
            begin = i + 1
    return parts


# Returns the function of an action, or None. If `sure` is false, also returns None if the text may be the beginning of another action.
def choose(act, parts, sure):
    name = parts[0]
    found = act.get(name)
    if found and not isinstance(found, tuple):
        found = found, 0
    if not found or len(parts) != found[1] + 1:
        return None
    if not sure:
        for other in act:
            if other != name and other[:len(name)] == name:
                return None
    return found[0]
