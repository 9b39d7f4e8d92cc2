"""Stands for the USB ports of CircuitPython."""
data = None
