"""Stands for CircuitPython's module, as far as the examples use it."""


class Direction:
    OUTPUT = 1


class DigitalInOut:
    def __init__(self, pin):
        self.direction, self.value = None, False
