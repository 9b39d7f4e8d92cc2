package javino.link;

import java.util.concurrent.TimeUnit;

/**
 * Decides when the driver may get the next frame. Uses the time, and the frames that were written and received.
 *
 * <p>Two limits hold a frame back. The first is the pace: the driver gets a frame when the previous frame has left the line, by the baud
 * rate. The second is the capacity of version 1 boards. Such a board reads the line once in each run of its {@code loop()}, and has room
 * for one message. If the bytes contain a message and the beginning of another frame, the board restarts. The board does not read while
 * it sends an answer. Therefore:
 * <ul>
 *   <li>A frame starts one gap after the end of the previous frame or answer. The gap is at least that of the settings. Unless the
 *       settings say 0, it is also at least the {@link GapEstimate}. Exception: the answer to the only open request shows that the board
 *       has handled all messages, if no action was written after the request. The first action after this answer starts at once.
 *   <li>While the board may be busy with an answer, the pacer limits the actions to the number that the board can hold. The pacer limits
 *       the bytes of the actions to the receive buffer of an AVR. The busy time ends with the answer, after {@value #QUIET_MILLIS} ms of
 *       silence within the answer, or {@value #MAX_ANSWER_DELAY_MILLIS} ms after the request.
 *   <li>If a board that has answered before misses an answer, it gets only urgent actions: see {@link Version1SilenceHold}.
 * </ul>
 * Version 2 boards announce how much they can receive, so only the pace limits them. An unpaced line has neither limit. Times are
 * nanoseconds of one steady clock. Guarded by its user's lock.
 */
final class Pacer {
    static final int QUIET_MILLIS = 50;
    /** A board begins its answer within this time: 50 ms for its loop, and 50 ms for its sensors, with a reserve. */
    static final int MAX_ANSWER_DELAY_MILLIS = 150;
    /**
     * Bytes that an AVR can hold unread. The AVR's buffer has 64 bytes. The limit leaves 4 bytes free for bytes that are being received.
     */
    static final int RECEIVE_BUFFER = 60;

    /** The number of late answers in a row that prove a slow board. This computer may cause one or two late answers. */
    private static final int MANY_LATE = 3;

    private static final long QUIET_NANOS = TimeUnit.MILLISECONDS.toNanos(QUIET_MILLIS);
    private static final int GAP_BYTES = 2;

    private final boolean paced;
    private final long byteNanos;
    private final long minGapNanos;
    private final int boardQueue;
    private final int maxHoldMillis;

    private long lineFreeAt;
    private long lastEnd; // end of the last frame or answer
    private final GapEstimate estimate = new GapEstimate();
    private long requestEnd;
    private boolean answerBegun;
    private boolean awaitingAnswer;
    private boolean actionSinceRequest;
    private int unanswered; // number of requests in a row without an answer
    private boolean boardIsIdle; // the board has handled all messages
    private long busyUntil;
    private final Version1SilenceHold silence = new Version1SilenceHold();
    private int lateAnswers; // number of late answers in a row
    private int actionsMeanwhile; // actions written while the board may be busy with the last request
    private int bytesMeanwhile;

    Pacer(LinkSettings settings, long now) {
        paced = settings.paced();
        byteNanos = settings.line().byteNanos();
        minGapNanos = TimeUnit.MILLISECONDS.toNanos(settings.spacingMillis());
        boardQueue = settings.boardQueue();
        maxHoldMillis = Math.max(settings.spacingMillis(), GapEstimate.MAX_MILLIS) + GapEstimate.MAX_DELAY_MILLIS;
        lineFreeAt = now;
        lastEnd = now - gap();
        busyUntil = now;
    }

    /**
     * Returns the most milliseconds for which a frame is held back on a free line: the gap, and the delay that
     * {@link GapEstimate} adds to learn a better gap.
     */
    int maxHoldMillis() {
        return maxHoldMillis;
    }

    /** Returns the nanoseconds from {@code now} until a frame of version 2 may be written; 0: now. */
    long nanosUntilFrame(long now) {
        return nanosUntil(lineFreeAt, now);
    }

    /** Returns the nanoseconds from {@code now} until an action of {@code bytes} may be written; 0: now. An answer may shorten the time. */
    long nanosUntilAction(int bytes, long now) {
        long free = boardIsIdle ? lineFreeAt : earliest();
        return nanosUntil(overfills(bytes) ? later(free, busyUntil) : free, now);
    }

    /** Returns the nanoseconds for which only urgent actions may be written if no answer comes; 0: any action may be written. */
    long nanosHeld(long now) {
        return paced ? silence.nanosHeld(now) : 0;
    }

    /** Returns whether the board's answers are so late that its {@code loop()} must take longer than the longest gap. */
    boolean isSlow() {
        return silence.isAnswering() && lateAnswers >= MANY_LATE;
    }

    /**
     * Returns the nanoseconds from {@code now} until a request may be written; 0: now.
     *
     * @param due time at which the request would go out on a free line
     */
    long nanosUntilRequest(long due, long now) {
        long free = actionsMeanwhile > 0 ? later(earliest(), busyUntil) : earliest();
        long probeDelay = minGapNanos == 0 ? 0 : estimate.probeDelayNanos();
        return nanosUntil(later(free, due) + probeDelay, now);
    }

    private long earliest() {
        return later(lineFreeAt, lastEnd + gap());
    }

    private long nanosUntil(long at, long now) {
        return paced ? Math.max(0, at - now) : 0;
    }

    /**
     * Records an action that the driver took from {@code start} to {@code now}. Returns the time at which the action's last byte leaves
     * the line.
     */
    long wroteAction(int bytes, long start, long now) {
        actionSinceRequest = true;
        if (mayBeBusy(start)) {
            actionsMeanwhile++;
            bytesMeanwhile += bytes;
        }
        return wroteFrame(bytes, start, now);
    }

    long wroteRequest(int bytes, long start, long now) {
        requestEnd = wroteFrame(bytes, start, now);
        if (unanswered++ > 0) {
            estimate.forget(); // the board's loop may take longer than before
        }
        estimate.asked();
        answerBegun = false;
        actionSinceRequest = false;
        actionsMeanwhile = 0;
        bytesMeanwhile = 0;
        awaitingAnswer = true;
        busyUntil = requestEnd + TimeUnit.MILLISECONDS.toNanos(MAX_ANSWER_DELAY_MILLIS);
        silence.asked(requestEnd);
        return requestEnd;
    }

    /** Records that all written bytes have arrived. A line may be faster than its rate, such as a pseudo-terminal. */
    void allArrived(long now) {
        lineFreeAt = now - lineFreeAt < 0 ? now : lineFreeAt;
    }

    long wroteFrame(int bytes, long start, long now) {
        if (paced) {
            long duration = bytes * byteNanos;
            boolean buffered = now - start < duration; // the driver may have begun the frame as late as now
            lineFreeAt = later(later(buffered ? now : start, lineFreeAt) + duration, now);
        } else {
            lineFreeAt = now;
        }
        lastEnd = lineFreeAt;
        boardIsIdle = false;
        return lastEnd;
    }

    /**
     * Records that one read returned {@code bytes}. The first byte arrived earlier than {@code now}, because each byte takes time on the
     * line.
     */
    void received(int bytes, long now) {
        if (awaitingAnswer) {
            if (!answerBegun) {
                answerBegun = true;
                long delay = now - (bytes - 1) * byteNanos - requestEnd;
                estimate.answeredAfter(delay);
                lateAnswers = delay > maxGapNanos() ? lateAnswers + 1 : 0;
            }
            busyUntil = later(busyUntil, now + QUIET_NANOS);
        }
    }

    void unanswered(long now) {
        lateAnswers += answerBegun ? 0 : 1;
        silence.unanswered(now);
    }

    private long maxGapNanos() {
        return Math.max(minGapNanos, TimeUnit.MILLISECONDS.toNanos(GapEstimate.MAX_MILLIS));
    }

    void answered(long now) {
        silence.heard(awaitingAnswer);
        if (!awaitingAnswer) {
            return;
        }
        awaitingAnswer = false;
        busyUntil = now;
        if (!actionSinceRequest) {
            lineFreeAt = now; // all bytes have left: the line may be faster than its rate
            lastEnd = now;
        }
        lastEnd = later(lastEnd, now);
        boardIsIdle = !actionSinceRequest && unanswered == 1;
        unanswered = 0;
    }

    private long gap() {
        if (minGapNanos == 0) {
            return 0;
        }
        return Math.max(minGapNanos, estimate.nanos() + GAP_BYTES * byteNanos);
    }

    private boolean overfills(int bytes) {
        return actionsMeanwhile >= boardQueue || bytesMeanwhile + bytes > RECEIVE_BUFFER;
    }

    private boolean mayBeBusy(long now) {
        return busyUntil - now > 0;
    }

    private static long later(long a, long b) {
        return a - b >= 0 ? a : b;
    }
}
