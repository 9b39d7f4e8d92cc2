"""The row of commands in the payload of COMMANDS."""
from typing import NamedTuple

NOTHING = None  # the item FE, which only takes a number
MAX_ACTION = 125


class Rule(NamedTuple):
    """A command that sets or removes rules."""
    text: bytes


def item(command):
    """Returns the bytes of one command: the number of an action, a text, a Rule, or NOTHING."""
    if command is NOTHING:
        return b"\xfe"
    if isinstance(command, int):
        if not 0 <= command <= MAX_ACTION:
            raise ValueError(f"no item for action number {command}")
        return bytes([0x80 + command])
    if isinstance(command, Rule):
        return bytes([0xFF, len(command.text)]) + command.text
    if not 1 <= len(command) <= 253:
        raise ValueError(f"a text of {len(command)} bytes fits into no frame")
    return (bytes([len(command)]) if len(command) < 0x80 else bytes([0, len(command)])) + command


def write_row(commands):
    return b"".join(item(c) for c in commands)


def read_row(row):
    """Returns the commands of a payload. A truncated or empty item ends the row."""
    commands = []
    while row:
        first, row = row[0], row[1:]
        if first == 0xFE:
            commands.append(NOTHING)
            continue
        if 0x80 <= first < 0xFE:
            commands.append(first - 0x80)
            continue
        length = first
        if first in (0, 0xFF):
            if not row:
                break
            length, row = row[0], row[1:]
        if not 0 < length <= len(row):
            break
        commands.append(Rule(row[:length]) if first == 0xFF else row[:length])
        row = row[length:]
    return commands
