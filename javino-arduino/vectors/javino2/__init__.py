"""Version 2 of the protocol, written from docs/protocol.md as plainly as possible: slow, and meant to be read.

Bytes and times go in, bytes come out; nothing here opens a line or reads a clock. Times are in milliseconds.
"""
