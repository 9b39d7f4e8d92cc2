#!/usr/bin/env python3
"""Explores both ends of version 2 exhaustively: every order of loss, repetition, refusal, restart and late outcome.

    model.py              explore all set-ups
    model.py --mutations  explore with each of a list of defects in a machine, and expect that a property fails

The machines are those of the reference, with few numbers before they wrap and a small window. The lines keep the order of frames and lose
any of them; damage is loss, and so are frames of another session. A frame to the board may come once more, later. Breadth first, so a
failure is shown by the shortest way to it.

The properties: a command reported done was carried out once, one reported refused was refused; all in order, none twice; no command behind
a refused one is handled before the computer has seen the refusal; a command whose time is over is not sent; a believed answer was given to
that request of that session; and from every state, if nothing more is lost, everything ends and a question is answered.
"""
import gc
import sys
import time
from collections import deque
from itertools import product
from typing import NamedTuple

from machines import Machine
from javino2 import board as boards
from javino2 import session as sessions, window as windows
from javino2.commands import NOTHING, read_row
from javino2.frames import ACK, ASK, COMMANDS, COMMANDS_RESUME, Frame, begins_sessions

NUMBERS, WINDOW, IN_FLIGHT, PART_SIZE = 4, 2, 2, 6
SHALLOW = 1000  # states of each set-up


class Violation(Exception):
    pass


class Stuck(Exception):
    """From this state on, although nothing is lost."""

    def __init__(self, state, what):
        super().__init__(what)
        self.state = state


class Setup(NamedTuple):
    """The events that may happen, and how often."""
    kinds: tuple  # for each command the ways in which it may end: D done, R refused, d done later, r refused later
    asks: int = 0
    board_restarts: int = 0
    computer_restarts: int = 0
    sessions_given_up: int = 0
    over: int = 0  # commands whose time is over while they are out
    strays: int = 0  # frames with a number that acknowledges more than is out
    copies: int = 0  # frames to the board that come once more, later


def next_nonce(last):
    if last == 100:
        raise Violation("one HELLO after another, and no session")
    return last + 1


KINDS = "DRdr"


def text_of(command, kind):
    """The command's text also tells the program how the command ends, so that one exploration has all ways."""
    return bytes([ord("a") + len(KINDS) * command + KINDS.index(kind)])


def number_of(text):
    return (text[0] - ord("a")) // len(KINDS)


def kind_of(text):
    return KINDS[(text[0] - ord("a")) % len(KINDS)]


class Program:
    """The board's program."""
    actions = ()

    def __init__(self):
        self.count = 0
        self.pending = None
        self.log = []

    def carry_out(self, text):
        command, kind = number_of(text), kind_of(text)
        if kind == "R":
            self.log.append(("refused", command))
            return boards.REFUSES
        self.count += 1
        self.log.append(("carried out", command))
        if kind == "D":
            return boards.DONE
        self.pending = text
        return boards.LATER

    def percepts(self, functors):
        return [b"m%d;" % self.count] * (self.count > 0) + [b"n%d;" % self.count]


def step_board(board, event):
    program = board.program
    if event == "report":
        refuses = kind_of(program.pending) == "r"
        if refuses:
            program.log.append(("refused", number_of(program.pending)))
        program.pending = None
        frames = board.report(boards.REFUSES if refuses else boards.DONE)
    else:
        if event.kind == ASK and board.session:
            program.log.append(("said", board.session, event.number, tuple(program.percepts(b""))))
        frames = board.receive(event)
        if not board.busy:
            program.pending = None
    log, program.log = tuple(program.log), []
    return tuple(frames), log


def step_computer(session, event):
    frames = []
    if event[0] == "frame":
        frames = session.receive(event[1], event[2])
    elif event[0] == "send":
        frames = [session.window.send(event[1])]
    elif event[0] == "ask":
        frames = [session.ask()]
    elif event[0] == "timer":
        frames = [session.repeat()]
    elif event[0] == "over":
        session.window.time_over(event[1])
    elif event[0] == "give up":
        frames = [session.give_up()]
    elif event[0] == "restart":
        session._close()
        session.outcomes = []
        frames = [session.hello()]
    outcomes = tuple((number_of(c), outcome) for c, outcome in session.outcomes)
    answers = tuple((session.nonce, request, tuple(texts)) for request, texts in session.answers if texts is not None)
    session.outcomes, session.answers, session.pages = [], [], []
    if session.open:
        session.impossible_numbers = 0  # here no number of them ends the session, so the count would only tell equal states apart
    return tuple(frames), outcomes, answers


class State(NamedTuple):
    computer: int
    board: int
    to_board: tuple
    to_computer: tuple
    copy: tuple  # frames that come once more
    left: tuple  # asks, board restarts, computer restarts, sessions given up, over, strays, copies
    sent: int  # commands that went out
    # a bit for each command
    carried: int
    refused: int
    over: int
    reported: int
    said: tuple  # (session, request, texts), for what was asked


class Model:
    def __init__(self, setup):
        self.setup = setup
        self.commands = len(setup.kinds)
        self.believed = 0
        self.computers, self.boards = Machine(step_computer), Machine(step_board)
        self.fresh_board = self.boards.id_of(self._board())
        # Only the protocol's other rules may show that a number cannot be right.
        session = sessions.Session(lambda last: next_nonce(last), NUMBERS, WINDOW, impossible=None)
        self.start = State(self.computers.id_of(session), self.fresh_board, (), (), (), setup[1:], 0, 0, 0, 0, 0, ())

    def _board(self):
        return boards.Board(Program(), numbers=NUMBERS, part_size=PART_SIZE)

    # ---- steps of one end ----

    def computer(self, state, event):
        id, (frames, outcomes, answers) = self.computers.after(state.computer, event)
        reported = state.reported
        for command, outcome in outcomes:
            self._check_outcome(state, reported, command, outcome)
            reported |= 1 << command
        for answer in answers:
            self.believed += 1
            if answer not in state.said:
                raise Violation(f"the answer {answer} is believed, and was never said")
        for frame in frames:
            self._check_sent(state, frame)
        sealed = sealed_in(self.computers.objects[id].nonce, frames)
        return state._replace(computer=id, to_board=state.to_board + sealed, reported=reported)

    def to_computer(self, state, sealed, lately):
        """A frame from the board arrives; one of another session is damaged."""
        nonce, frame = sealed
        session = self.computers.objects[state.computer]
        return self.computer(state, ("frame", frame, lately)) if nonce in (0, session.nonce if session.open else 0) else state

    def to_board(self, state, sealed):
        """A frame from the computer arrives; a board without a session cannot tell of which it is."""
        nonce, frame = sealed
        session = self.boards.objects[state.board].session
        return self.board(state, frame) if not nonce or session in (0, nonce) else state

    def board(self, state, event):
        id, (frames, log) = self.boards.after(state.board, event)
        for what, *about in log:
            if what == "said":
                state = state._replace(said=state.said + (tuple(about),))
            elif what == "refused":
                self._check_order(state, about[0])
                state = state._replace(refused=state.refused | 1 << about[0])
            else:
                self._check_order(state, about[0])
                if state.carried >> about[0]:
                    raise Violation(f"command {about[0]} is carried out after {bin(state.carried)}: twice, or out of order")
                state = state._replace(carried=state.carried | 1 << about[0])
        return state._replace(board=id, to_computer=state.to_computer + sealed_in(self.boards.objects[id].session, frames))

    # ---- properties ----

    @staticmethod
    def _check_outcome(state, reported, command, outcome):
        if reported >> command & 1:
            raise Violation(f"the outcome of command {command} is reported twice")
        refused, carried = state.refused >> command & 1, state.carried >> command & 1
        if outcome == windows.DONE and (refused or not carried):
            raise Violation(f"command {command} is reported done, and was {'refused' if refused else 'not carried out'}")
        if outcome == windows.REFUSED and not refused:
            raise Violation(f"command {command} is reported refused, and was not")
        if outcome == windows.DONE and ~reported & ((1 << command) - 1):
            raise Violation(f"command {command} is reported done before one in front of it")

    @staticmethod
    def _check_order(state, command):
        for c in range(command):
            if state.refused >> c & 1 and not state.reported >> c & 1:
                raise Violation(f"command {command} is handled before the computer has seen that {c} was refused")

    @staticmethod
    def _check_sent(state, frame):
        if frame.kind in (COMMANDS, COMMANDS_RESUME):
            for command in read_row(frame.payload):
                if command is not NOTHING and state.over >> number_of(command) & 1:
                    raise Violation(f"command {number_of(command)} is sent although its time is over")

    def needed(self, state):
        """Returns the state without what no check reads any more, so that states which differ in nothing else are one.

        Of the commands that are reported, only the number of the last one carried out is read, and of the board's answers only those to
        questions that are open.
        """
        session = self.computers.objects[state.computer]
        carried = state.carried & ~state.reported | 1 << state.carried.bit_length() >> 1
        said = state.said and tuple(s for s in state.said if session.open and s[0] == session.nonce and s[1] in session.asked)
        return state._replace(carried=carried, refused=state.refused & ~state.reported, said=said)

    # ---- events ----

    def next(self, state):
        """Yields all events that may happen: words for show(), and a function that returns the next state."""
        session = self.computers.objects[state.computer]
        board = self.boards.objects[state.board]
        left = state.left
        room = IN_FLIGHT - len(state.to_board)
        if state.to_board:
            behind = state._replace(to_board=state.to_board[1:])
            yield "lost on the way to the board", lambda: behind
            if len(state.to_computer) < IN_FLIGHT:
                yield ("to the board:", state.to_board[0]), lambda: self.to_board(behind, state.to_board[0])
                if left[6]:
                    copied = spend(behind, 6)._replace(copy=state.copy + state.to_board[:1])
                    yield ("to the board, and later again:", state.to_board[0]), lambda: self.to_board(copied, state.to_board[0])
        if state.copy and len(state.to_computer) < IN_FLIGHT:
            rest = state._replace(copy=state.copy[1:])
            yield ("to the board once more:", state.copy[0]), lambda: self.to_board(rest, state.copy[0])
        if state.to_computer:
            before = state._replace(to_computer=state.to_computer[1:])
            yield "lost on the way to the computer", lambda: before
            if room:
                frame = state.to_computer[0]
                yield ("to the computer:", frame), lambda: self.to_computer(before, frame, False)
                yield ("to the computer, lately repeated:", frame), lambda: self.to_computer(before, frame, True)
        if board.busy and len(state.to_computer) < IN_FLIGHT:
            yield "the outcome of an action", lambda: self.board(state, "report")
        if room:
            yield from self._sendings(state, session)
        if left[1]:
            yield "the board restarts", lambda: spend(state, 1)._replace(board=self.fresh_board)
        if left[5] and session.open and len(session.window.out) < WINDOW and room:
            stray = Frame(ACK, (session.window.oldest + len(session.window.out) + 1) % NUMBERS)
            yield "a stray ACK", lambda: self.computer(spend(state, 5), ("frame", stray, True))
        if left[4] and session.open:
            for entry in session.window.out:
                if not entry.over:
                    yield ("the time is over of", entry.command), lambda text=entry.command: self._over(state, text)

    def _over(self, state, text):
        state = self.computer(spend(state, 4), ("over", text))
        return state._replace(over=state.over | 1 << number_of(text))

    def _sendings(self, state, session):
        left = state.left
        if session.open and session.window.out or not session.open:
            yield "timer", lambda: self.computer(state, ("timer",))
        if session.open:
            for n in range(1, min(session.window.room(), self.commands - state.sent) + 1):
                for row in self._rows(state, n):
                    yield ("are sent:", *row), lambda row=row: self._send(state, row)
            if left[0]:
                yield "ask", lambda: self.computer(spend(state, 0), ("ask",))
            if left[3]:
                yield "the session is given up", lambda: self.computer(spend(state, 3), ("give up",))
        if left[2]:
            yield "the computer restarts", lambda: self._restart(state, session)

    def _rows(self, state, n):
        """Returns the rows of the next n commands, in all ways in which these may end."""
        return product(*([text_of(c, kind) for kind in self.setup.kinds[c]] for c in range(state.sent, state.sent + n)))

    def _send(self, state, row):
        return self.computer(state, ("send", row))._replace(sent=state.sent + len(row))

    def _restart(self, state, session):
        """The commands that were out are forgotten with the computer."""
        reported = state.reported
        if session.open:
            for entry in session.window.out:
                reported |= 1 << number_of(entry.command)
        return self.computer(spend(state, 2), ("restart",))._replace(reported=reported)

    # ---- progress ----

    def settled(self, state):
        session = self.computers.objects[state.computer]
        return (session.open and not session.window.out and state.sent == self.commands and not state.to_board and not state.to_computer
                and not self._is_deaf(state))

    def _is_deaf(self, state):
        """Returns true if the board has the session of an earlier HELLO, so that it takes and sends nothing of this one."""
        return self.boards.objects[state.board].session not in (0, self.computers.objects[state.computer].nonce)

    def fair(self, state):
        """Returns the next state if nothing is lost and no timer is early."""
        if state.to_board:
            return self.to_board(state._replace(to_board=state.to_board[1:]), state.to_board[0])
        if state.to_computer:
            return self.to_computer(state._replace(to_computer=state.to_computer[1:]), state.to_computer[0], False)
        if self.boards.objects[state.board].busy:
            return self.board(state, "report")
        session = self.computers.objects[state.computer]
        if session.open and self._is_deaf(state):
            return self.computer(state, ("give up",))  # behind four repetitions without an answer
        if session.open and not session.window.out and state.sent < self.commands:
            return self._send(state, next(self._rows(state, min(WINDOW, self.commands - state.sent))))
        return self.computer(state, ("timer",))

    def check_progress(self, states):
        good = set()
        for state in states:
            try:
                self._check_ends(state, good)
            except Violation as violation:
                raise Stuck(state, violation) from None

    def _check_ends(self, state, good):
        """Checks that from here on everything ends, and a question is answered; `good` are the states of which this is known."""
        way, end = self._way_to_end(state, good)
        if end not in good:
            self._check_answered(end)
        good |= way
        good.add(end)

    def _way_to_end(self, state, good=()):
        """Returns the states in front of the first one that is settled or known to be good, and that one."""
        way = set()
        while state not in good and not self.settled(state):
            if state in way:
                raise Violation("the same happens again and again")
            way.add(state)
            state = self.needed(self.fair(state))
        return way, state

    def _check_answered(self, state):
        """Checks that one of three questions is answered: the first may find that the board was restarted, the second a void answer."""
        before = self.believed
        for _ in range(3):
            _, state = self._way_to_end(self.computer(state, ("ask",)))
            if self.believed > before:
                return
        raise Violation("three questions without an answer")


def spend(state, what):
    left = list(state.left)
    left[what] -= 1
    return state._replace(left=tuple(left))


def sealed_in(nonce, frames):
    """Frames as the line carries them: with the nonce of their session, 0 for those that are the same in all."""
    return tuple((0 if begins_sessions(frame.kind) else nonce, frame) for frame in frames)


def show(words):
    """The text of an event: words, commands' texts and frames, also in tuples."""
    if isinstance(words, bytes):
        return f"{number_of(words)}{kind_of(words)}"
    if isinstance(words, str):
        return words
    if isinstance(words[-1], Frame):
        frame = words[-1]
        return f"{frame.kind:02X} {frame.number} {frame.payload.hex()}"
    return " ".join(map(show, words))


def explore(setup, limit=10**9):
    """Explores all states, and returns how many there are. A violation is raised with the shortest way to it."""
    model = Model(setup)
    came = {model.start: None}
    todo = deque([model.start])
    while todo and len(came) < limit:
        state = todo.popleft()
        for words, event in model.next(state):
            try:
                after = model.needed(event())
            except Violation as violation:
                raise Violation("\n".join(way_to(came, state) + [show(words), f"=> {violation}"])) from None
            if after not in came:
                came[after] = (state, words)
                todo.append(after)
    try:
        model.check_progress(came)
    except Stuck as stuck:
        raise Violation("\n".join(way_to(came, stuck.state) + [f"=> then, although nothing more is lost: {stuck}"])) from None
    return len(came)


def way_to(came, state):
    way = []
    while came[state] is not None:
        state, words = came[state]
        way.append(show(words))
    return way[::-1]


def setups():
    """The set-ups that are explored: all outcomes of the commands, and in turn everything else that may happen."""
    yield Setup(["RDd"], asks=2, sessions_given_up=1)
    yield Setup(["RDd"], asks=2, board_restarts=1)
    yield Setup(["RDd"] * 2, asks=2)
    yield Setup(["RDd"] * 3, strays=1)
    yield Setup(["RDd"] * 3, over=1)
    yield Setup(["RDd"] * 3, computer_restarts=1)
    yield Setup(["RDd"] * 3, sessions_given_up=1)
    yield Setup(["RDd"] * 3, board_restarts=1)
    yield Setup(["RDd"] * 2, copies=1, sessions_given_up=1)
    yield Setup(["R", "D"], board_restarts=1, computer_restarts=1, sessions_given_up=1, over=1)
    yield Setup([KINDS] * 4)


def explore_all(limit=10**9):
    """The number of set-ups and of states, of each set-up so many at most."""
    counts = [explore(setup, limit) for setup in setups()]
    return len(counts), sum(counts)


def check_mutations():
    """Returns true if the model finds every defect of the list."""
    from mutations import MUTATIONS
    missed = 0
    for name, defect in MUTATIONS:
        with defect:
            try:
                explore_all(SHALLOW)  # most defects show in some set-up soon
                explore_all()
                print(f"not found: {name}")
                missed += 1
            except Violation as violation:
                print(f"{name}:\n    " + str(violation).replace("\n", "\n    "))
    print(f"  model of version 2: {len(MUTATIONS) - missed} of {len(MUTATIONS)} defects found")
    return missed == 0


def main():
    begun = time.monotonic()
    gc.disable()  # all states are kept to the end, so a search for garbage among them only costs time
    if sys.argv[1:] == ["--mutations"]:
        return 0 if check_mutations() else 1
    count, states = explore_all()
    print(f"  model of version 2: {count} set-ups, {states} states explored, {time.monotonic() - begun:.0f} s")
    return 0


if __name__ == "__main__":
    import model  # so that the defects are put into the module that runs
    sys.exit(model.main())
