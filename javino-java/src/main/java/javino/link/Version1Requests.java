package javino.link;

import java.util.concurrent.TimeUnit;
import javino.Frame;
import javino.LineClock;
import javino.PortException;

/**
 * Asks and listens in version 1: sends requests, and finds the answer to the last request among the board's messages. Times are
 * nanoseconds of the link's clock. Not thread-safe.
 */
final class Version1Requests {
    /** Milliseconds after which a request to a board that may be starting is repeated. */
    static final int REPEAT_MILLIS = 250;

    private static final long QUIET_NANOS = TimeUnit.MILLISECONDS.toNanos(Pacer.QUIET_MILLIS);

    private final Inbox inbox;
    private final FrameWriter writer;
    private final LineClock clock;
    private final BoardStatus board;
    private final OwedAnswers owed = new OwedAnswers();
    private boolean isListening; // a caller waits for messages that the board sends unasked
    private boolean isForAction; // the request only precedes an action; nobody wants the answer
    private Reply overheard; // answer to such a request, kept for a caller that listens, or null

    Version1Requests(Inbox inbox, FrameWriter writer, LineClock clock, BoardStatus board) {
        this.inbox = inbox;
        this.writer = writer;
        this.clock = clock;
        this.board = board;
    }

    /** Sets whether later requests only precede an action. */
    void askForAction(boolean value) {
        isForAction = value;
    }

    /** Sends a request and returns its answer, or null if none comes in time. Repeats the request while the board may be starting. */
    Reply request(Frame request, int timeoutMillis) throws PortException {
        overheard = null;
        long timeoutNanos = TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        long starting = board.nanosToStart();
        if (starting > 0) {
            return askUntil(clock.nanos() + Math.max(starting, timeoutNanos), request, timeoutMillis);
        }
        Reply answer = inbox.next(ask(request, timeoutMillis) + timeoutNanos);
        if (answer == null) {
            writer.unanswered(clock.nanos());
            return null;
        }
        return completed(answer, timeoutMillis);
    }

    /** Repeats the request until an answer comes, at most until {@code giveUp}. Returns null if no answer came. */
    Reply askUntil(long giveUp, Frame request, int timeoutMillis) throws PortException {
        long repeatNanos = TimeUnit.MILLISECONDS.toNanos(Math.min(timeoutMillis, REPEAT_MILLIS));
        Reply answer = null;
        for (long left = giveUp - clock.nanos();
                answer == null && left > 0 && !board.speaks2();
                left = giveUp - clock.nanos()) {
            long sent = ask(request, timeoutMillis);
            answer = awaitAnswer(sent, sent + Math.min(left, repeatNanos), giveUp);
        }
        return answer == null ? null : completed(answer, timeoutMillis);
    }

    /** Sends a request, unless the board turns out to speak version 2. Returns the time at which the request's last byte leaves. */
    long ask(Frame request, int timeoutMillis) throws PortException {
        long sent = writer.write(FrameWriter.Kind.REQUEST, request.length(), timeoutMillis, () -> {
            if (!(isForAction && isListening)) {
                inbox.clear();
            }
            if (board.speaks2()) { // a session may have begun, and this request would end it
                return null;
            }
            inbox.sends(request);
            return request.toBytes();
        });
        if (!board.speaks2()) {
            owed.asked(sent);
        }
        return sent;
    }

    /** Completes an exchange whose first message is {@code first}. Returns the answer. */
    Reply completed(Reply first, int timeoutMillis) throws PortException {
        board.heard();
        Reply answer = last(first, timeoutMillis);
        if (isForAction && isListening) {
            overheard = answer;
        }
        writer.answered(clock.nanos());
        return answer;
    }

    /** Returns the newest message that the board sends on its own, or null if none comes by {@code deadline}. */
    Reply listen(long deadline) throws PortException {
        isListening = true;
        Reply message = overheard != null ? overheard : inbox.next(deadline);
        overheard = null;
        if (message == null) {
            return null;
        }
        board.heard();
        writer.answered(clock.nanos()); // a board that speaks is not busy with an old request
        return newest(message);
    }

    /**
     * Returns the next message if it is complete by {@code deadline}. If the message has begun by {@code deadline}, waits for its end
     * until {@code giveUp}. Returns null if no message comes.
     */
    Reply awaitAnswer(long sent, long deadline, long giveUp) throws PortException {
        Reply answer = inbox.next(deadline);
        while (answer == null && isComing(sent) && giveUp - clock.nanos() > 0) {
            answer =
                    inbox.next(inbox.lastByteNanos() + QUIET_NANOS); // a repetition would drop the bytes that have come
        }
        return answer;
    }

    private boolean isComing(long sent) {
        return !board.speaks2()
                && inbox.lastByteNanos() - sent > 0
                && clock.nanos() - inbox.lastByteNanos() < QUIET_NANOS;
    }

    private Reply last(Reply first, int timeoutMillis) throws PortException {
        if (owed.mayBeLate()) {
            return lastBeforeSilence(first, TimeUnit.MILLISECONDS.toNanos(timeoutMillis));
        }
        owed.answered(clock.nanos());
        return newest(first); // an intact answer may follow a truncated message
    }

    private Reply newest(Reply message) throws PortException {
        Reply newer = inbox.newest();
        return newer == null ? message : newer;
    }

    private Reply lastBeforeSilence(Reply first, long timeoutNanos) throws PortException {
        long now = clock.nanos();
        long giveUp = now + timeoutNanos;
        long settlingNanos = owed.settlingNanos(now, timeoutNanos);
        Reply last = first;
        while (giveUp - clock.nanos() > 0 && !board.speaks2()) {
            long left = Math.min(inbox.lastByteNanos() + settlingNanos, giveUp) - clock.nanos();
            Reply later = inbox.next(clock.nanos() + left);
            if (later != null) {
                last = later;
            } else if (clock.nanos() - inbox.lastByteNanos() >= settlingNanos) {
                owed.settled();
                return last;
            }
        }
        return last; // the line never fell silent, so the next answer may also be late
    }
}
