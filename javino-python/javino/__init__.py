"""The Javino protocol for boards in Python. An agent requests percepts from the board and sends it actions.

    import javino

    board = javino.Board("/dev/ttyGS0")
    board.act["ledOn"] = lambda: print("on")
    board.perceive(lambda: board.percept("light", "front", 512))
    board.run_forever()

Runs on CPython 3.8 and newer, MicroPython and CircuitPython.
"""
from .board import ANY, Board, Refused
from .lines import LineGone

__all__ = ("ANY", "Board", "LineGone", "Refused")
__version__ = "0.1.0"
