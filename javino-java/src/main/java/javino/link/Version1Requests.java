package javino.link;

import java.util.concurrent.TimeUnit;
import javino.Frame;
import javino.LineClock;
import javino.PortException;

/**
 * Asks and listens in version 1: sends requests, and finds the answer to the last request among the messages from the board. Times are
 * nanoseconds of the link's clock. One thread at a time.
 */
final class Version1Requests {
    /** Milliseconds after which a board that may be starting is asked again. */
    static final int REPEAT_MILLIS = 250;

    private static final long QUIET_NANOS = TimeUnit.MILLISECONDS.toNanos(Pacer.QUIET_MILLIS);

    private final Inbox inbox;
    private final FrameWriter writer;
    private final LineClock clock;
    private final KnownBoard board;
    private final OwedAnswers owed = new OwedAnswers();
    private boolean isListening; // a caller wants messages that the board sends unasked
    private boolean isForAction; // the board is asked because an action is to be sent; nobody wants the answer
    private Reply overheard; // answer to a request that an action needed, kept for a caller that listens; null: none

    Version1Requests(Inbox inbox, FrameWriter writer, LineClock clock, KnownBoard board) {
        this.inbox = inbox;
        this.writer = writer;
        this.clock = clock;
        this.board = board;
    }

    /** Sets whether requests from now on are made only because of an action. */
    void askForAction(boolean value) {
        isForAction = value;
    }

    /** Sends a request and returns its answer; null: none comes in time. Repeats the request while the board may be starting. */
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

    /** Repeats the request until it is answered, or until {@code giveUp}; null: no answer. */
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
            if (board.speaks2()) { // a session may have begun meanwhile, which a request of version 1 would end
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

    /** Completes an exchange whose first message is {@code first}; returns the answer. */
    Reply completed(Reply first, int timeoutMillis) throws PortException {
        board.heard();
        Reply answer = last(first, timeoutMillis);
        if (isForAction && isListening) {
            overheard = answer;
        }
        writer.answered(clock.nanos());
        return answer;
    }

    /** The newest message that the board sends of its own accord; null: none comes by {@code deadline}. */
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

    /** The next message, if complete by {@code deadline}, or begun by then and complete by {@code giveUp}; null: there is none. */
    Reply awaitAnswer(long sent, long deadline, long giveUp) throws PortException {
        Reply answer = inbox.next(deadline);
        while (answer == null && isComing(sent) && giveUp - clock.nanos() > 0) {
            answer = inbox.next(inbox.lastByteNanos() + QUIET_NANOS); // a repetition would drop what has come
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
        return last; // the line never fell silent: the next answer may be late too
    }
}
