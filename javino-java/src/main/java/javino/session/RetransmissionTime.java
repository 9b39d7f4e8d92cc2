package javino.session;

import java.util.concurrent.TimeUnit;

/**
 * The time after which unacknowledged frames are repeated: twice the smoothed round trip, counted from their last byte. Each unanswered
 * repetition doubles the time, up to a limit.
 */
final class RetransmissionTime {
    private static final long MIN_NANOS = TimeUnit.MILLISECONDS.toNanos(60);
    private static final long MAX_DOUBLED_NANOS = TimeUnit.MILLISECONDS.toNanos(500);
    private static final long FIRST_NANOS = TimeUnit.MILLISECONDS.toNanos(150);

    private static final int SMOOTHING = 8;

    private long smoothedNanos; // smoothed round trip, or 0
    private int doublings;

    /** Records the time from the last byte of a frame to its acknowledgement. Call this only for a frame that was sent once. */
    void measured(long nanos) {
        long atLeast1 = Math.max(1, nanos);
        smoothedNanos =
                smoothedNanos == 0 ? atLeast1 : Math.max(1, smoothedNanos + (atLeast1 - smoothedNanos) / SMOOTHING);
    }

    void news() {
        doublings = 0;
    }

    void timedOut() {
        doublings++;
    }

    /** @param lineNanos nanoseconds that the unacknowledged frames take on the line */
    long nanos(long lineNanos) {
        long base = Math.max(MIN_NANOS, (smoothedNanos == 0 ? FIRST_NANOS : 2 * smoothedNanos) + lineNanos);
        return Math.max(base, Math.min(base << Math.min(doublings, 10), MAX_DOUBLED_NANOS));
    }
}
