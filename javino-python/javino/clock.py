"""A clock of milliseconds, which wraps on microcontrollers, and the difference of two of its times."""
try:
    from time import ticks_diff, ticks_ms
except ImportError:
    from time import monotonic_ns

    def ticks_ms():
        """Milliseconds since some moment."""
        return monotonic_ns() // 1000000

    def ticks_diff(later, earlier):
        """Milliseconds between two times."""
        return later - earlier
