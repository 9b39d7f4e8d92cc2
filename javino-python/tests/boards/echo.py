"""A board for the tests. Writes every action that it carries out to standard error. echo.py FOLDER [LINE [SEED]]

With a seed, one byte in 200 is damaged, in both directions.
"""
import sys

sys.path.insert(0, sys.argv[1])
import javino  # noqa: E402
from javino.clock import ticks_diff, ticks_ms  # noqa: E402

board = javino.Board(sys.argv[2] if len(sys.argv) > 2 else None)
if hasattr(board.line, "name"):
    sys.stderr.write("line %s\n" % board.line.name)


def harm(seed):
    """Damages one byte in 200 on the line from now on."""
    import random
    rng = random.Random(seed)
    read, write = board.line.read, board.line.write

    def damage(data):
        return bytes([byte ^ rng.randrange(1, 256) if rng.randrange(200) == 0 else byte for byte in data])
    board.line.read = lambda: damage(read())
    board.line.write = lambda data: write(damage(data))


if len(sys.argv) > 3:
    harm(int(sys.argv[3]))
state = {"count": 0, "dist": 100, "closing": 0, "begun": 0, "near": 0, "asked": False}


def tell(text):
    sys.stderr.write(text + "\n")
    if hasattr(sys.stderr, "flush"):
        sys.stderr.flush()


def note(text):
    state["count"] += 1
    tell(text)


def speed(value):
    if value == 0:
        return False
    note("speed(%s)" % value)


def grip(ends):
    """Succeeds with true and kept, fails with false and dropped. With kept and dropped, ends only after a request for closing."""
    note("grip(%s)" % ends)
    state["closing"], state["begun"], state["ok"] = board.later(), ticks_ms(), ends in ("true", "kept")
    state["asked"] = ends in ("true", "false")


def step():
    if state["near"] and ticks_diff(ticks_ms(), state["begun"]) > 50:
        state["dist"], state["near"] = state["near"], 0
    if state["closing"] and state["asked"] and ticks_diff(ticks_ms(), state["begun"]) > 100:
        later, state["closing"] = state["closing"], 0
        board.done(later, state["ok"])


def fail():
    raise javino.Refused


@board.perceive
def look():
    state["asked"] = state["asked"] or board.wants("closing")
    board.percept("count", state["count"])
    board.percept("dist", "f", state["dist"])
    if board.wants("text"):
        board.percept("text", "a \"b\"; c", 1.5, True, [1, "x"])


for name in ("led", "ledOn", "stop"):
    board.on_action(name, lambda name=name: note(name))
board.on_action("speed", speed, 1)
board.on_action("say", lambda *texts: note("say %d %s" % (len(texts), len(texts[0]))), javino.ANY)
board.on_action("near", lambda cm: state.update({"near": cm, "begun": ticks_ms()}), 1)  # after 50 ms
board.on_action("grip", grip, 1)
board.act["fail"] = fail
board.watch_rules()
board.on_link_lost(400, lambda: tell("lost"))
try:
    board.run_forever(step)
except javino.LineGone:
    pass
