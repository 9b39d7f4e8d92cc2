package javino.link;

import java.util.Arrays;
import java.util.concurrent.TimeUnit;

/**
 * Estimates the gap that a version 1 board needs between frames: the time from one of its reads of the line to the next. The delay of an
 * answer has two parts: the time until the board's next read, a random part of its {@code loop()}; and the time to measure and to build the
 * answer, which is about constant. So the differences between delays show how long the loop takes.
 * <p>The estimate is a multiple of the range of the last {@value #SAMPLES} delays: twice the range, or more while there are so few delays
 * that their range may be much shorter than the loop. The range of n random delays is less than the part x of the loop with a probability
 * below n x^(n-1). If one delay is left out, this probability is below n (n-1) x^(n-2). The multiple is 1/x for the x at which this
 * probability is one in 100,000. The estimate is at most {@value #MAX_MILLIS} ms, since the sensors may cause the differences. Until
 * {@value #MIN_SAMPLES} delays are known, the estimate is this maximum. From {@value #MANY} delays on, the longest is left out; of more
 * delays, one in {@value #OUTLIER_AMONG} at each end. So one stall of this computer does not slow commands down.
 * <p>If each request came the same time after the last answer, all requests would meet the same part of the loop. So some requests are sent
 * later, spread evenly over the longest delay seen: each of the first {@value #LEARNING_REQUESTS}, then one in {@value #PROBE_AMONG}. Times
 * are nanoseconds. Guarded by its user's lock.
 */
final class GapEstimate {
    static final int SAMPLES = 256;
    /** The longest estimate, also used while no loop is known: the sensors of many sketches take that long. */
    static final int MAX_MILLIS = 50;
    /** Fewer delays prove nothing: over USB a delay is a whole number of milliseconds, so they may be equal by chance. */
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
    /** The multiples of this number have fractional parts that are spread evenly. */
    private static final double GOLDEN_RATIO = 0.6180339887498949;
    /** The delay of an answer that takes longer is ignored: the answer belongs to an earlier request. Also the longest probe delay. */
    static final int MAX_DELAY_MILLIS = 200;

    private static final long MAX_DELAY_NANOS = TimeUnit.MILLISECONDS.toNanos(MAX_DELAY_MILLIS);

    private final long[] delays = new long[SAMPLES];
    private final long[] sorted = new long[SAMPLES]; // the delays in ascending order
    private int count;
    private int next;
    private long estimate;
    private long longest;
    private int requests;

    /** Records that an answer began {@code delayNanos} after its request had left; less than 0 counts as 0. */
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

    /** Forgets all delays: an answer is missing, so the loop may take longer than before. */
    void forget() {
        count = 0;
        next = 0;
        requests = 0;
    }

    void asked() {
        requests++;
    }

    /** Nanoseconds by which the next request is delayed on purpose, to meet another part of the loop. */
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
