"""Stands for CircuitPython's module, as far as the examples use it."""


class AnalogIn:
    value = 32768

    def __init__(self, pin):
        pass
