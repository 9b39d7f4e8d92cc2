"""Version 1 of the protocol. Times are in milliseconds and only ever passed in."""

PREAMBLE = b"fffe"
HEX = b"0123456789abcdefABCDEF"


def frame(payload):
    """A frame around at most 255 bytes."""
    return PREAMBLE + b"%02X" % len(payload) + payload


class Decoder:
    """A receiver by the protocol's rules."""

    def __init__(self, timeout=100):
        self.timeout = timeout
        self.window = b""
        self.delivered = 0  # bytes at the window's start that are a frame which has been delivered
        self.last = 0
        self.messages = []

    def receive(self, data, now):
        """Takes bytes that arrive together."""
        self.idle(now)
        for byte in data:
            self.window += bytes([byte])
            self._parse()
        self.last = now

    def idle(self, now):
        """Says that it is this late and that nothing else has arrived."""
        if now - self.last <= self.timeout:
            return
        while self.window:
            if self.delivered == len(self.window):
                self._drop(self.delivered)
            elif self.delivered and self._header(self.window[self.delivered:]) == "yes":
                self._drop(self.delivered)
            else:
                self._drop(1)
            self._parse()

    def in_payload(self):
        """Whether the next byte belongs to a frame whose header is complete."""
        return not self.delivered and self._header(self.window) == "yes"

    def forget(self):
        """Drops what has been read."""
        self._drop(len(self.window))

    def _drop(self, count):
        self.window = self.window[count:]
        self.delivered = 0

    def _parse(self):
        while self.window:
            if self.delivered:
                follows = self._header(self.window[self.delivered:])
                if follows == "maybe":
                    return
                self._drop(self.delivered if follows == "yes" else 1)
                continue
            header = self._header(self.window)
            if header == "maybe":
                return
            if header == "no":
                self._drop(1)
                continue
            end = 6 + int(self.window[4:6], 16)
            if len(self.window) < end:
                return
            self.messages.append(self.window[6:end])
            self.delivered = end

    @staticmethod
    def _header(data):
        """Whether a preamble and two hex digits stand here: yes, no or maybe (too few bytes to know)."""
        if not PREAMBLE.startswith(data[:4]) or any(c not in HEX for c in data[4:6]):
            return "no"
        return "yes" if len(data) >= 6 else "maybe"
