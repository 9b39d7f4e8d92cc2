"""The part of CircuitPython's module that the examples use."""


class AnalogIn:
    value = 32768

    def __init__(self, pin):
        pass
