"""The part of MicroPython's machine that the examples use, and MicroPython's clock."""
import time

time.ticks_ms = lambda: time.monotonic_ns() // 1000000
time.ticks_add = lambda ticks, delta: ticks + delta
time.ticks_diff = lambda later, earlier: later - earlier


class Pin:
    OUT = 1

    def __init__(self, number, mode=0):
        self.state = 0

    def on(self):
        self.state = 1

    def off(self):
        self.state = 0


class ADC:
    def __init__(self, pin):
        pass

    def read_u16(self):
        return 32768


class PWM:
    def __init__(self, pin):
        pass

    def freq(self, hertz):
        pass

    def duty_u16(self, duty):
        assert isinstance(duty, int) and 0 <= duty <= 65535


class UART:
    def __init__(self, number, baud, rxbuf=64):
        pass
