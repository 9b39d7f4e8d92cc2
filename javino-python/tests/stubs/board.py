"""The pins of CircuitPython."""
LED = A0 = None
