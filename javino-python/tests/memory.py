"""A line without a device."""


class Memory:
    def __init__(self):
        self.arrives, self.sent = b"", b""

    def read(self):
        data, self.arrives = self.arrives, b""
        return data

    def write(self, data):
        self.sent += data

    def wait(self, ms):
        pass
