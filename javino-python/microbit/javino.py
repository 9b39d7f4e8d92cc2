# Version 1 of the Javino protocol for the first micro:bit. Its MicroPython has 9 KB of memory and limits calls to a depth of six. run()
# therefore makes few calls. The files are small, because MicroPython compiles each file separately.
from microbit import running_time, uart
from micropython import kbd_intr

from javframe import find
from javtext import choose, split, term


class Board:
    def __init__(self, baud=115200):
        kbd_intr(-1)  # the byte 03 is data
        uart.init(baud)
        self.act = {}
        self._look = None
        self._lost = None
        self._text = ""
        self._in = b""
        self._heard = self._valid = running_time()

    def on_action(self, name, function, arguments=0):
        self.act[name] = (function, arguments)

    def perceive(self, function):
        self._look = function

    def on_link_lost(self, ms, function):
        self._lost = ms, function
        self._valid = running_time()

    def percept(self, functor, *arguments):
        text = functor
        mark = "("
        for a in arguments:
            text += mark + term(a)
            mark = ","
        text += ");" if arguments else ";"
        if len(self._text) + len(text) > 255:
            self.send_percepts()
        self._text += text

    def send_percepts(self):
        data = "fffe%02X" % len(self._text) + self._text
        self._text = ""
        uart.write(data)

    def run(self):
        now = running_time()  # read before the bytes: a later time would count as silence
        if uart.any():
            self._in += uart.read(64)
            self._heard = now
        while self._in:
            self._in, size, sure = find(self._in, now - self._heard)
            if not size:
                break
            self._valid = now
            if self._in[6:17] == b"getPercepts":
                if self._look:
                    self._look()
                self.send_percepts()
            else:
                parts = split("".join([chr(b) for b in self._in[6:size]]))
                function = choose(self.act, parts, sure)
                if function:
                    try:
                        function(*parts[1:])
                    except (TypeError, ValueError):  # a damaged argument
                        pass
                elif not sure:
                    size = 1
            self._in = self._in[size:]
        if self._lost and now - self._valid > self._lost[0]:
            self._valid = now + 0x20000000  # no further call until something arrives
            self._lost[1]()

    def run_forever(self, step=None):
        while True:
            self.run()
            if step:
                step()
