package javino;

import java.util.Arrays;

/**
 * How long a board's sketch may take from one look at the line to the next, as far as its answers show it: a request waits for the next
 * look, so the time from its last byte to the first byte of its answer is a part of one round, a random one.
 *
 * <p>The estimate is twice the longest of the last {@value #SAMPLES}: as many, since requests that are sent in step with the sketch see the
 * same short part of its round again and again. Of each {@value #ALONE_AMONG} the longest does not count, or one hiccup of this computer or of
 * the board would keep commands apart for a minute. Times are nanoseconds. Guarded by its user's lock.
 */
final class LoopTime {
    static final int SAMPLES = 256;
    private static final int ALONE_AMONG = 64;
    /** A board that takes longer to answer is measuring something, not looking elsewhere; or what came is no answer. */
    private static final long MAX_DELAY_NANOS = 50_000_000L;
    /** The longest estimate. */
    static final long MAX_NANOS = 2 * MAX_DELAY_NANOS;

    private final long[] delays = new long[SAMPLES];
    private int count;
    private int next;
    private long longest;

    /** Says that an answer began {@code delayNanos} after its request had left; less than 0 counts as 0. */
    void answeredAfter(long delayNanos) {
        if (delayNanos > MAX_DELAY_NANOS) {
            return;
        }
        delays[next] = Math.max(0, delayNanos);
        next = (next + 1) % SAMPLES;
        count = Math.min(count + 1, SAMPLES);
        long[] sorted = Arrays.copyOf(delays, count);
        Arrays.sort(sorted);
        longest = sorted[count - 1 - count / ALONE_AMONG];
    }

    /** The estimate; 0 before the first answer. */
    long nanos() {
        return 2 * longest;
    }
}
