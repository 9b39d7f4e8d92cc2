"""Stands for the pins of CircuitPython."""
LED = A0 = None
