"""The row of commands in the payload of COMMANDS."""

NOTHING = None  # the item FE: a number that is used up
MAX_ACTION = 125


def item(command):
    """The bytes of one command: the number of an action, a text, or NOTHING."""
    if command is NOTHING:
        return b"\xfe"
    if isinstance(command, int):
        if not 0 <= command <= MAX_ACTION:
            raise ValueError(f"no item for action number {command}")
        return bytes([0x80 + command])
    if not 1 <= len(command) <= 253:
        raise ValueError(f"a text of {len(command)} bytes fits into no frame")
    return (bytes([len(command)]) if len(command) < 0x80 else bytes([0, len(command)])) + command


def write_row(commands):
    return b"".join(item(c) for c in commands)


def read_row(row):
    """The commands of a payload; an item that is cut, an empty text, or FF ends it."""
    commands = []
    while row:
        first, row = row[0], row[1:]
        if first == 0xFF:
            break
        if first == 0xFE:
            commands.append(NOTHING)
            continue
        if first >= 0x80:
            commands.append(first - 0x80)
            continue
        if first == 0:
            if not row:
                break
            first, row = row[0], row[1:]
        if not 0 < first <= len(row):
            break
        commands.append(row[:first])
        row = row[first:]
    return commands
