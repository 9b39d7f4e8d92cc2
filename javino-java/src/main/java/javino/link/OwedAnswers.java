package javino.link;

import java.util.concurrent.TimeUnit;

/**
 * Counts the requests whose answers are missing. A late answer would pass for the answer to the next request, and all later answers would
 * be one request late. After a missed answer the next exchange therefore listens until the line has been silent for a while, and takes
 * the last answer. Times are nanoseconds of one steady clock. Not thread-safe.
 */
final class OwedAnswers {
    private static final long MIN_SETTLING_NANOS = TimeUnit.MILLISECONDS.toNanos(50);
    /** If the first answer takes longer, the board was starting. Such an answer does not show a slow board. */
    private static final long SLOWEST_BOARD_NANOS = TimeUnit.SECONDS.toNanos(1);

    private long longestNanos; // longest time of an answer; 0 if none has been timed
    private int asked; // number of requests since the last time that no answer was missing
    private long firstAskedAt;

    void asked(long nanos) {
        if (asked == 0) {
            firstAskedAt = nanos;
        }
        asked++;
    }

    /** Returns whether a message that arrives now may answer an earlier request. */
    boolean mayBeLate() {
        return asked > 1;
    }

    void answered(long now) {
        longestNanos = Math.max(longestNanos, now - firstAskedAt);
        asked = 0;
    }

    /** Records that the line has fallen silent. No answer is missing any more. */
    void settled() {
        asked = 0;
    }

    /**
     * Returns the nanoseconds of silence after which no further answer is expected: twice the longest time of an answer, at least 50 ms
     * and at most {@code timeoutNanos}. If no answer has been timed, uses the time since the first request instead. If the board was just
     * starting, uses the least time.
     *
     * @param answerAt time at which the first message arrived
     */
    long settlingNanos(long answerAt, long timeoutNanos) {
        long sinceFirst = answerAt - firstAskedAt;
        long slow = longestNanos > 0 ? 2 * longestNanos : sinceFirst < SLOWEST_BOARD_NANOS ? sinceFirst : 0;
        return Math.min(Math.max(MIN_SETTLING_NANOS, slow), timeoutNanos);
    }
}
