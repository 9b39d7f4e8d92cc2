"""A board without motors: the agent perceives typed lines, and can print texts.

    program.py              prints the port that the agent opens, a pseudo-terminal
    program.py tcp://127.0.0.1:4000
"""
import sys
import threading

import javino

board = javino.Board(sys.argv[1] if len(sys.argv) > 1 else "pty:/tmp/program")
typed = []
threading.Thread(target=lambda: [typed.append(line.strip()) for line in sys.stdin], daemon=True).start()


@board.perceive
def look():
    if typed:
        board.percept("typed", len(typed), typed[-1])


board.on_action("say", print, 1)
print("the agent's port is", board.line.name, flush=True)
board.run_forever()
