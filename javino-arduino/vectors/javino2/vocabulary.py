"""The actions of a board, in pages."""

ANY_NUMBER = 0xFF  # any number of arguments
MAX_ACTIONS = 126
MAX_NAME = 250


def numbered(actions):
    """Returns the actions that get a number. A board leaves out the other actions, and reports how many there are."""
    return [action for action in actions if len(action[0]) <= MAX_NAME][:MAX_ACTIONS]


def write_page(request, actions, first, room=252):
    """Returns a payload with whole actions from number `first` on, as many as fit into `room` bytes. An action is (name, arguments)."""
    page = bytes([request, first, len(actions)])
    for name, arguments in actions[first:]:
        action = bytes([arguments, len(name)]) + name
        if len(page) - 3 + len(action) > room:
            break
        page += action
    return page


def read_page(payload):
    """Returns (request, first, total, actions) of a payload, or None if the payload is truncated."""
    if len(payload) < 3:
        return None
    request, first, total = payload[:3]
    actions, rest = [], payload[3:]
    while rest:
        if len(rest) < 2 or len(rest) < 2 + rest[1]:
            return None
        arguments, n = rest[:2]
        actions.append((rest[2:2 + n], arguments))
        rest = rest[2 + n:]
    return request, first, total, actions


def number_of(actions, name):
    """Returns the number of the newest action `name`. Returns None if the command must go out as text."""
    for i in reversed(range(len(actions))):
        if actions[i][0] == name:
            return i if i <= 125 and actions[i][1] in (0, ANY_NUMBER) else None
    return None
