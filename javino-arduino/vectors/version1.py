"""Version 1 of the protocol. Times are in milliseconds."""

PREAMBLE = b"fffe"
HEX = b"0123456789abcdefABCDEF"


def frame(payload):
    return PREAMBLE + b"%02X" % len(payload) + payload


class Decoder:
    """A receiver of version 1.

    `other` is the byte that begins frames of version 2, or None if only version 1 uses the line. If `anywhere` is true, a frame may
    begin at any byte. Otherwise a frame may begin only after a silence, which sets `quiet`. Messages go to `deliver`. If `deliver`
    is None, `messages` keeps the messages.
    """

    def __init__(self, timeout=100, other=None, deliver=None):
        self.timeout = timeout
        self.other = other
        self.anywhere = self.quiet = True
        self.window = b""
        self.delivered = 0  # length of the delivered frame at the window's start
        self.last = 0
        self.messages = []
        self.deliver = self.messages.append if deliver is None else deliver

    def receive(self, data, now):
        """Takes bytes that arrive together."""
        self.idle(now)
        for byte in data:
            self.put(byte)
        self.last = now

    def idle(self, now):
        """Call this if no byte has arrived up to this time."""
        if now - self.last <= self.timeout:
            return
        while self.window:
            self.give_up()

    def put(self, byte):
        """Takes a byte. If `other` comes outside of frames of version 1, returns the bytes from `other` on."""
        self.window += bytes([byte])
        return self._parse()

    def give_up(self):
        """Handles silence. Drops a delivered frame, or reads an incomplete frame again from its second byte. Returns bytes like put."""
        following = self.window[self.delivered:]
        if self.delivered and (not following or self._header(following) == "yes"):
            self._drop(self.delivered)
        else:
            self._misread()
        return self._parse()

    def waits(self):
        """Returns true if a frame is being read."""
        return len(self.window) > self.delivered

    def _drop(self, count):
        self.window = self.window[count:]
        self.delivered = 0

    def _misread(self):
        self._drop(1)
        self.quiet = self.anywhere

    def _parse(self):
        while self.window:
            if self.window[0] == self.other:
                rest = self.window
                self._drop(len(rest))
                return rest
            if self.delivered:
                following = self.window[self.delivered:]
                follows = "yes" if following and following[0] == self.other else self._header(following)
                if follows == "maybe":
                    break
                if follows == "yes":
                    self._drop(self.delivered)
                else:
                    self._misread()
                continue
            header = self._header(self.window) if self.quiet else "no"
            if header == "maybe":
                break
            if header == "no":
                self._misread()
                continue
            end = 6 + int(self.window[4:6], 16)
            if len(self.window) < end:
                break
            self.delivered = end
            self.deliver(self.window[6:end])
            self.quiet = self.anywhere
        return b""

    @staticmethod
    def _header(data):
        """Tells whether data begins with a preamble and two hex digits: yes, no, or maybe if there are too few bytes."""
        if not PREAMBLE.startswith(data[:4]) or any(c not in HEX for c in data[4:6]):
            return "no"
        return "yes" if len(data) >= 6 else "maybe"
