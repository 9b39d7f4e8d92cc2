"""Version 1 of the protocol. Times are in milliseconds and only ever passed in."""

PREAMBLE = b"fffe"
HEX = b"0123456789abcdefABCDEF"


def frame(payload):
    """A frame around at most 255 bytes."""
    return PREAMBLE + b"%02X" % len(payload) + payload


class Decoder:
    """A receiver by the protocol's rules.

    Where version 2 shares the line, `other` is the byte with which its frames begin. `anywhere` says whether a frame may begin at any byte,
    or only at one in front of which `quiet` was set. Messages are given to `deliver`, or kept in `messages`.
    """

    def __init__(self, timeout=100, other=None, deliver=None):
        self.timeout = timeout
        self.other = other
        self.anywhere = self.quiet = True
        self.window = b""
        self.delivered = 0  # bytes at the window's start that are a frame which has been delivered
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
        """Says that it is this late and that nothing else has arrived."""
        if now - self.last <= self.timeout:
            return
        while self.window:
            self.give_up()

    def put(self, byte):
        """Takes a byte. Returns the bytes from `other` on, if that is found where no frame of version 1 is."""
        self.window += bytes([byte])
        return self._parse()

    def give_up(self):
        """Nothing follows: drops the frame that was delivered, or reads what is incomplete again from its second byte. Returns as put."""
        following = self.window[self.delivered:]
        if self.delivered and (not following or self._header(following) == "yes"):
            self._drop(self.delivered)
        else:
            self._misread()
        return self._parse()

    def waits(self):
        """Whether a frame is being read."""
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
        """Whether a preamble and two hex digits stand here: yes, no or maybe (too few bytes to know)."""
        if not PREAMBLE.startswith(data[:4]) or any(c not in HEX for c in data[4:6]):
            return "no"
        return "yes" if len(data) >= 6 else "maybe"
