"""Replaces the USB ports of CircuitPython."""
data = None
