"""The part of CircuitPython's module that the examples use."""


class Direction:
    OUTPUT = 1


class DigitalInOut:
    def __init__(self, pin):
        self.direction, self.value = None, False
