"""Version 2 of the protocol, written from docs/protocol.md as plainly as possible. The code is slow, and meant to be read. Bytes and
times go in, and bytes come out. This package opens no line and reads no clock. Times are in milliseconds."""
