package javino;

/**
 * When the next frame may be handed to the driver: a function of the time and of what was written and received before.
 *
 * <p>Two things hold a frame back. The pace: the driver is given a frame when the one before has left the line by the baud rate. And
 * courtesy to version 1 boards, which hold few received messages, overwrite one that they have not handled with the next, and do not read
 * while they send an answer:
 * <ul>
 *   <li>an action ends {@code spacing} after the frame before it, and a request starts {@code spacing} after the last action;
 *   <li>while the board may be busy with an answer, it gets no more actions than it can hold, and no more bytes than the receive buffer of
 *       an AVR. It may be busy until the answer is complete and {@code spacing} has passed, or until it has been silent for
 *       {@value #QUIET_MILLIS} ms;
 *   <li>a request waits until it has had time for the actions it got meanwhile.
 * </ul>
 * {@code spacing} is what was asked for, or more for a board whose answers show that it looks at the line more seldom, see
 * {@link LoopTime}. Version 2 boards hold what they receive, and acknowledge actions, of which one is on its way at a time. They are left their receive buffer,
 * and no other courtesy. A line that is not paced knows neither. Times are nanoseconds of one steady clock. Guarded by its user's lock.
 */
final class Pacer {
    static final int QUIET_MILLIS = 50;
    /** Bytes that an AVR holds unread: its buffer has 64, less some for bytes that are being received. */
    static final int RECEIVE_BUFFER = 60;

    private static final long NANOS_PER_MILLI = 1_000_000L;
    private static final long QUIET_NANOS = QUIET_MILLIS * NANOS_PER_MILLI;

    private final boolean paced;
    private final long byteNanos;
    private final long spacingNanos;
    private final int boardQueue;
    private boolean version2;

    private long lineFreeAt;
    private long frameEnd; // of the last frame
    private long actionEnd; // of the last action
    private final LoopTime loop = new LoopTime();
    private long requestEnd;
    private boolean answerBegun;
    private boolean awaitingAnswer;
    private boolean actionSinceRequest;
    private long busyUntil;
    private int actionsMeanwhile; // written while the board may have been busy with the last request
    private int bytesMeanwhile;

    /** @param now the time at which the line was opened */
    Pacer(LinkSettings settings, long now) {
        paced = settings.paced();
        byteNanos = settings.line().byteNanos();
        spacingNanos = settings.spacingMillis() * NANOS_PER_MILLI;
        boardQueue = settings.boardQueue();
        lineFreeAt = now;
        frameEnd = now - spacingNanos;
        actionEnd = now - spacingNanos;
        busyUntil = now;
        version2 = settings.protocol() == Protocol.V2;
    }

    /** Says that the board speaks version 2. */
    void speakVersion2() {
        version2 = true;
    }

    /** Nanoseconds from {@code now} until an action of {@code bytes} may be written; 0: now. An answer that arrives may shorten it. */
    long nanosUntilAction(int bytes, long now) {
        if (!paced) {
            return 0;
        }
        long at = version2 ? lineFreeAt : later(lineFreeAt, frameEnd + spacing() - bytes * byteNanos);
        if (overfills(bytes)) {
            at = later(at, busyUntil);
        }
        return Math.max(0, at - now);
    }

    /** Nanoseconds from {@code now} until a request may be written; 0: now. */
    long nanosUntilRequest(long now) {
        if (!paced) {
            return 0;
        }
        if (version2) {
            return Math.max(0, lineFreeAt - now);
        }
        long at = later(lineFreeAt, actionEnd + spacing());
        if (actionsMeanwhile > 0) {
            at = later(at, busyUntil);
        }
        return Math.max(0, at - now);
    }

    /**
     * Says that an action was written.
     *
     * @param start when it was handed to the driver
     * @param now when the driver had taken it
     * @return when its last byte has left
     */
    long wroteAction(int bytes, long start, long now) {
        actionSinceRequest = true;
        if (mayBeBusy(start)) {
            actionsMeanwhile++;
            bytesMeanwhile += bytes;
        }
        actionEnd = wrote(bytes, start, now);
        return actionEnd;
    }

    /** Says that a request was written; as {@link #wroteAction}. */
    long wroteRequest(int bytes, long start, long now) {
        requestEnd = wrote(bytes, start, now);
        answerBegun = false;
        actionSinceRequest = false;
        actionsMeanwhile = 0;
        bytesMeanwhile = 0;
        awaitingAnswer = true;
        busyUntil = frameEnd + QUIET_NANOS;
        return frameEnd;
    }

    private long wrote(int bytes, long start, long now) {
        if (paced) {
            lineFreeAt = later(later(start, lineFreeAt) + bytes * byteNanos, now);
            frameEnd = lineFreeAt;
        } else {
            frameEnd = now;
        }
        return frameEnd;
    }

    /** Says that {@code bytes} were there when the line was looked at: the first of them came earlier, by the time that the others took. */
    void received(int bytes, long now) {
        if (awaitingAnswer) {
            if (!answerBegun) {
                answerBegun = true;
                loop.answeredAfter(now - (bytes - 1) * byteNanos - requestEnd);
            }
            busyUntil = later(busyUntil, now + QUIET_NANOS);
        }
    }

    /** Says that a message is complete: the answer, if one is awaited. */
    void answered(long now) {
        if (!awaitingAnswer) {
            return;
        }
        awaitingAnswer = false;
        if (!actionSinceRequest) {
            frameEnd = now - LoopTime.MAX_NANOS - spacingNanos; // the board has handled all it got: what comes next need not keep its distance
            lineFreeAt = now; // so all has left, if the line is faster than its rate says, as a pseudo-terminal is
            busyUntil = now;
        } else {
            busyUntil = now + spacing();
        }
    }

    /** The distance to keep: what was asked for, and what the board's loop needs; none if none was asked for. */
    private long spacing() {
        return spacingNanos == 0 ? 0 : Math.max(spacingNanos, loop.nanos());
    }

    private boolean overfills(int bytes) {
        return !version2 && actionsMeanwhile >= boardQueue || bytesMeanwhile + bytes > RECEIVE_BUFFER;
    }

    private boolean mayBeBusy(long now) {
        return busyUntil - now > 0;
    }

    private static long later(long a, long b) {
        return a - b >= 0 ? a : b;
    }
}
