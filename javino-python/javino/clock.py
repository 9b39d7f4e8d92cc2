"""A clock in milliseconds, and the difference of two times. On microcontrollers the clock wraps around."""
try:
    from time import ticks_diff, ticks_ms
except ImportError:
    from time import monotonic_ns

    def ticks_ms():
        """Returns milliseconds since a fixed moment."""
        return monotonic_ns() // 1000000

    def ticks_diff(later, earlier):
        """Returns the milliseconds between two times."""
        return later - earlier
