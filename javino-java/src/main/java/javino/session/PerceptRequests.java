package javino.session;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javino.wire.FrameKind;
import javino.wire.PerceptDecoder;
import javino.wire.WireFrame;

/**
 * Asks for percepts and reads the answers. Repeats a request if its answer is damaged, or takes longer than twice the smoothed time of
 * earlier answers. Takes the first answer to any request since the last answer.
 */
final class PerceptRequests {
    private static final int NUMBERS = 255;
    private static final long MIN_TIMEOUT_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
    private static final long FIRST_TIMEOUT_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    private static final int MAX_DOUBLINGS = 4;
    /** The silence after which no answer is arriving. Four byte times count instead if they are longer. */
    private static final long QUIET_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

    private static final int QUIET_BYTES = 4;
    /** The longest time by which arriving bytes postpone a repetition. Bytes on a line that is never silent are not the answer. */
    private static final long MAX_POSTPONED_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

    private static final int SMOOTHING = 4;

    private final long quietNanos;
    private final PerceptDecoder reader = new PerceptDecoder();
    private final AnswerParts parts = new AnswerParts();
    private long asked; // number of requests in this session
    private long answered; // number of requests that are answered, or precede an answered one
    private String wanted; // functors of the wanted percepts; null if none are wanted
    private boolean isOut; // whether a request for the wanted percepts has been sent
    private boolean isDamaged;
    private int repetitions;
    private int doublings;
    private long dueAt;
    private long leftAt;
    private long smoothedNanos; // smoothed time of the answers, or 0
    private long lastByteAt;
    private int bytes; // length of the newest request; 0 if it is answered

    PerceptRequests(long byteNanos) {
        quietNanos = Math.max(QUIET_NANOS, QUIET_BYTES * byteNanos);
    }

    void want(String functors, long now) {
        wanted = functors;
        isOut = false;
        isDamaged = false;
        repetitions = 0;
        dueAt = now;
    }

    void cancel() {
        wanted = null;
    }

    boolean isWanted() {
        return wanted != null;
    }

    /** Forgets the session's state. If percepts are wanted, the next session requests them. */
    void reset(long now) {
        reader.forget();
        parts.forget();
        asked = 0;
        answered = 0;
        bytes = 0;
        isOut = false;
        dueAt = now;
    }

    int bytes() {
        return bytes;
    }

    long nanosUntilDue(long now) {
        return wanted == null ? Long.MAX_VALUE : Math.max(0, dueAt() - now);
    }

    private long dueAt() {
        if (!isOut) {
            return dueAt;
        }
        long at = isDamaged ? leftAt : dueAt;
        return at - lastByteAt >= quietNanos ? at : Math.min(lastByteAt + quietNanos, at + MAX_POSTPONED_NANOS);
    }

    WireFrame next(int longestPayload, int nonce) {
        int number = (int) (asked++ % NUMBERS) + 1;
        if (isOut) {
            repetitions++;
            doublings = isDamaged ? doublings : Math.min(doublings + 1, MAX_DOUBLINGS);
        }
        isOut = true;
        isDamaged = false;
        String functors = wanted.length() < longestPayload ? wanted : ""; // if the list is too long, asks for all
        WireFrame frame = WireFrame.of(FrameKind.ASK, number, (char) reader.known() + functors);
        bytes = frame.toBytes(nonce).length;
        return frame;
    }

    void left(long at) {
        leftAt = at;
        long timeout = smoothedNanos == 0 ? FIRST_TIMEOUT_NANOS : Math.max(MIN_TIMEOUT_NANOS, 2 * smoothedNanos);
        dueAt = at + (timeout << doublings);
    }

    void receiving(long now) {
        lastByteAt = now;
    }

    /** Records that a damaged frame has arrived. The damaged frame may be the answer. */
    void damaged() {
        isDamaged |= isOut;
    }

    /** Takes a frame of percepts. If the frame completes an answer, reports the answer. */
    <C> void accept(WireFrame frame, long now, int limit, SessionListener<C> listener) {
        AnswerParts.Answer answer = parts.accept(frame);
        if (answer == null) {
            return;
        }
        Optional<String> text;
        try {
            text = answer.items() == null ? Optional.empty() : reader.read(answer.items(), limit);
        } catch (PerceptDecoder.TooLongException e) {
            listener.dropped();
            return;
        }
        if (answer.request() == 0) {
            text.ifPresent(listener::heard);
            return;
        }
        long behind = Math.floorMod((asked - 1) % NUMBERS + 1 - answer.request(), (long) NUMBERS);
        if (behind < asked - answered) { // neither this request nor a later one is answered yet
            answered(asked - behind, text, now, listener);
        }
    }

    private <C> void answered(long request, Optional<String> text, long now, SessionListener<C> listener) {
        if (text.isEmpty()) {
            damaged();
            return;
        }
        boolean isLate = wanted == null || !isOut;
        answered = isLate ? request : asked;
        if (answered == asked) {
            bytes = 0;
        }
        if (isLate) {
            return;
        }
        if (repetitions == 0) {
            long took = Math.max(1, now - leftAt);
            smoothedNanos = smoothedNanos == 0 ? took : Math.max(1, smoothedNanos + (took - smoothedNanos) / SMOOTHING);
            doublings = 0;
        }
        wanted = null;
        listener.answered(text.get());
    }
}
