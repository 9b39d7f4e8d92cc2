package javino.link;

import java.util.Arrays;
import java.util.concurrent.TimeUnit;

/**
 * Estimates the gap that a version 1 board needs between frames: the time between two of its reads of the line. The delay of an answer
 * has two parts. The first part is the time until the board's next read. This time varies at random within one {@code loop()}. The second
 * part is the time to measure and to build the answer. This time is about constant. The differences between delays therefore show how
 * long the loop takes.
 * <p>The estimate is the range of the last {@value #SAMPLES} delays times a factor of at least 2. With few delays their range may be much
 * shorter than the loop, so the factor is larger. The range of n random delays is less than the part x of the loop with a probability
 * below n x^(n-1). Without the longest delay, this probability is below n (n-1) x^(n-2). The factor is 1/x for the x at which this
 * probability is one in 100,000. Sensors may also cause differences, so the estimate is at most {@value #MAX_MILLIS} ms. Until
 * {@value #MIN_SAMPLES} delays are known, the estimate is this maximum. From {@value #MANY} delays on, the range ignores the longest
 * delay. With many delays it ignores one in {@value #OUTLIER_AMONG} at each end. One stall of this computer therefore does not slow
 * commands down.
 * <p>Requests at a constant time after the last answer would all meet one part of the loop. Some requests are therefore delayed on
 * purpose: each of the first {@value #LEARNING_REQUESTS}, then one in {@value #PROBE_AMONG}. The delays on purpose are spread evenly over
 * the longest delay of an answer. Times are nanoseconds. Guarded by its user's lock.
 */
final class GapEstimate {
    static final int SAMPLES = 256;
    /** The longest estimate. Also the estimate while too few delays are known. In many sketches, the sensors take up to 50 ms. */
    static final int MAX_MILLIS = 50;
    /**
     * The number of delays that an estimate needs. Over USB a delay is a whole number of milliseconds, so a few delays may be equal by
     * chance.
     */
    static final int MIN_SAMPLES = 6;
    /** The highest probability that the estimate is shorter than the loop. */
    private static final double CHANCE = 1e-5;

    private static final int MIN_MULTIPLE = 2;

    private static final long MAX_NANOS = TimeUnit.MILLISECONDS.toNanos(MAX_MILLIS);
    private static final int OUTLIER_AMONG = 64;
    private static final int MANY = 16;

    private static final int LEARNING_REQUESTS = 32;
    private static final int PROBE_AMONG = 8;
    private static final long MIN_PROBE_NANOS = TimeUnit.MILLISECONDS.toNanos(10);
    /** Multiples of this number have evenly spread fractional parts. */
    private static final double GOLDEN_RATIO = 0.6180339887498949;
    /** Longer delays are ignored: the answer belongs to an earlier request. Also the longest delay on purpose. */
    static final int MAX_DELAY_MILLIS = 200;

    private static final long MAX_DELAY_NANOS = TimeUnit.MILLISECONDS.toNanos(MAX_DELAY_MILLIS);

    private final long[] delays = new long[SAMPLES];
    private final long[] sorted = new long[SAMPLES]; // the delays in ascending order
    private int count;
    private int next;
    private long estimate;
    private long longest;
    private int requests;

    /** Records that an answer began {@code delayNanos} after its request had left. A negative delay counts as 0. */
    void answeredAfter(long delayNanos) {
        if (delayNanos > MAX_DELAY_NANOS) {
            return;
        }
        if (count == SAMPLES) {
            remove(delays[next]);
        }
        delays[next] = Math.max(0, delayNanos);
        insert(delays[next]);
        next = (next + 1) % SAMPLES;
        int outliers = count / OUTLIER_AMONG;
        int longestLeftOut = count < MANY ? 0 : Math.max(1, outliers);
        long range = sorted[count - 1 - longestLeftOut] - sorted[outliers];
        estimate = (long) Math.min(MAX_NANOS, multiple() * range);
        longest = sorted[count - 1];
    }

    private void remove(long delay) {
        int place = Arrays.binarySearch(sorted, 0, count, delay);
        count--;
        System.arraycopy(sorted, place + 1, sorted, place, count - place);
    }

    private void insert(long delay) {
        int found = Arrays.binarySearch(sorted, 0, count, delay);
        int place = found < 0 ? -found - 1 : found;
        System.arraycopy(sorted, place, sorted, place + 1, count - place);
        sorted[place] = delay;
        count++;
    }

    /** Forgets all delays. Called after a missing answer, because the loop may take longer now. */
    void forget() {
        count = 0;
        next = 0;
        requests = 0;
    }

    void asked() {
        requests++;
    }

    /** Returns the nanoseconds by which the next request is delayed on purpose, to meet another part of the loop. */
    long probeDelayNanos() {
        if (requests >= LEARNING_REQUESTS && requests % PROBE_AMONG != 0) {
            return 0;
        }
        int probe = requests < LEARNING_REQUESTS ? requests : requests / PROBE_AMONG;
        return (long) (probe * GOLDEN_RATIO % 1 * Math.max(MIN_PROBE_NANOS, longest));
    }

    long nanos() {
        return count < MIN_SAMPLES ? MAX_NANOS : estimate;
    }

    private double multiple() {
        double sets = count < MANY ? count : (double) count * (count - 1);
        int others = count < MANY ? count - 1 : count - 2;
        return Math.max(MIN_MULTIPLE, Math.pow(sets / CHANCE, 1.0 / others));
    }
}
