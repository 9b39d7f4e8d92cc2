"""The unacknowledged commands. This module has no clock."""
from typing import NamedTuple

from . import commands
from .frames import COMMANDS, COMMANDS_RESUME, Frame

DONE, REFUSED, UNCONFIRMED = "done", "refused", "unconfirmed"
MAX_ROW = 32


class Out(NamedTuple):
    command: object  # a command of commands.py
    over: bool = False  # the command's time is over, or nobody waits for its outcome
    as_nothing: bool = False  # the last frame had FE in place of the command


class News(NamedTuple):
    outcomes: list = []  # (command, outcome), in order
    again: bool = False  # the unacknowledged commands must be sent again at once
    accepted: bool = False  # the frame's number was possible


class Window:
    """Numbers wrap after `numbers`. At most `size` commands may be unacknowledged."""

    def __init__(self, numbers=256, size=16):
        self.numbers, self.size = numbers, size
        self.oldest = 0
        self.out = []
        self.resume = self.busy = False

    def room(self):
        return self.size - len(self.out)

    def send(self, row):
        """Returns the frame for new commands."""
        first = (self.oldest + len(self.out)) % self.numbers
        self.out += [Out(command) for command in row]
        return self._frame(first, row)

    def repetition(self):
        """Returns a frame that repeats the oldest unacknowledged commands, as many as fit."""
        row = []
        for i, entry in enumerate(self.out):
            command = commands.NOTHING if entry.over else entry.command
            if row and len(commands.write_row(row + [command])) > MAX_ROW:
                break
            row.append(command)
            self.out[i] = entry._replace(as_nothing=entry.over)
        return self._frame(self.oldest, row)

    def _frame(self, first, row):
        kind = COMMANDS_RESUME if self.resume and first == self.oldest else COMMANDS
        return Frame(kind, first, commands.write_row(row))

    def time_over(self, command):
        self.out = [entry._replace(over=True) if entry.command == command else entry for entry in self.out]

    def heard(self, due, refused, busy):
        """Takes the acknowledgement in a frame from the board."""
        count = (due - self.oldest) % self.numbers
        if not self.accepts(count):
            return News()
        done, self.out = self.out[:count], self.out[count:]
        outcomes = [(entry.command, UNCONFIRMED if entry.as_nothing else DONE) for entry in done]
        if done and refused:
            outcomes[-1] = (done[-1].command, REFUSED)
        again = bool(done and self.out) and (refused or self.busy and not busy)
        if not refused:
            self.resume = False
        elif done:
            self.resume = True
        self.oldest = due
        self.busy = busy
        return News(outcomes, again, True)

    def accepts(self, count):
        return count <= len(self.out)

    def give_up(self):
        """Returns the outcomes when the session ends."""
        outcomes = [(entry.command, UNCONFIRMED) for entry in self.out]
        self.out = []
        return outcomes
