package javino;

import java.util.concurrent.TimeUnit;

/**
 * Estimates when a frame that was not answered is to be retransmitted: after twice the longest time that an answer has taken. Only answers
 * to frames that were sent once are timed, since others may belong to any of their copies. One thread at a time.
 */
final class RoundTripTimes {
    private static final long MIN_TIMEOUT_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
    private static final int MAX_BACKOFF = 4;

    private final long unknownTimeoutNanos;
    private long longestNanos;
    private int backoff;

    /** @param unknownTimeoutMillis the timeout while no answer has been timed */
    RoundTripTimes(long unknownTimeoutMillis) {
        unknownTimeoutNanos = TimeUnit.MILLISECONDS.toNanos(unknownTimeoutMillis);
    }

    /** Records the time from the last byte of a frame to its answer. */
    void answeredAfter(long nanos) {
        longestNanos = Math.max(longestNanos, nanos);
        backoff = 0;
    }

    /** Records that an answer was late: the timeout is doubled until the next one is timed. */
    void timedOut() {
        backoff = Math.min(backoff + 1, MAX_BACKOFF);
    }

    /** The longest time that an answer has taken; 0: none has been timed. */
    long longestNanos() {
        return longestNanos;
    }

    /** Nanoseconds after which an answer is late. */
    long timeoutNanos() {
        return (longestNanos == 0 ? unknownTimeoutNanos : Math.max(MIN_TIMEOUT_NANOS, 2 * longestNanos)) << backoff;
    }
}
