package javino.link;

import java.util.concurrent.TimeUnit;

/**
 * Counts the answers that a board owes. A late answer would pass for the answer to the next request, and from then on each answer would be
 * one request late. So after a missed answer the next exchange listens until the line has been silent for a while, and takes the last
 * answer. Times are nanoseconds of one steady clock. One thread at a time.
 */
final class OwedAnswers {
    private static final long MIN_SETTLING_NANOS = TimeUnit.MILLISECONDS.toNanos(50);
    /** If the first answer takes longer than this, the board was starting, and is not slow. */
    private static final long SLOWEST_BOARD_NANOS = TimeUnit.SECONDS.toNanos(1);

    private long longestNanos; // the longest time that an answer has taken; 0: none has been timed
    private int asked; // requests since the board last owed no answer
    private long firstAskedAt;

    void asked(long nanos) {
        if (asked == 0) {
            firstAskedAt = nanos;
        }
        asked++;
    }

    /** Returns whether a message that arrives now may answer an earlier request than the last. */
    boolean mayBeLate() {
        return asked > 1;
    }

    void answered(long now) {
        longestNanos = Math.max(longestNanos, now - firstAskedAt);
        asked = 0;
    }

    /** Records that the line has fallen silent: the board owes no answer any more. */
    void settled() {
        asked = 0;
    }

    /**
     * Nanoseconds of silence after which no further answer is expected: twice the longest time that an answer has taken, at least 50 ms and
     * at most {@code timeoutNanos}. If no answer has been timed yet, the time since the first request counts instead, unless the board was
     * just starting.
     *
     * @param answerAt time at which the first message arrived
     */
    long settlingNanos(long answerAt, long timeoutNanos) {
        long sinceFirst = answerAt - firstAskedAt;
        long slow = longestNanos > 0 ? 2 * longestNanos : sinceFirst < SLOWEST_BOARD_NANOS ? sinceFirst : 0;
        return Math.min(Math.max(MIN_SETTLING_NANOS, slow), timeoutNanos);
    }
}
