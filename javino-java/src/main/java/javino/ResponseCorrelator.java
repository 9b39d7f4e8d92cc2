package javino;

import java.util.concurrent.TimeUnit;

/**
 * Finds the answer to the last request among the messages of version 1 that come, and waits for it.
 *
 * <p>Times are nanoseconds of the link's clock. One thread at a time.
 */
final class ResponseCorrelator {
    private static final long QUIET_NANOS = TimeUnit.MILLISECONDS.toNanos(Pacer.QUIET_MILLIS);

    private final Inbox inbox;
    private final LineClock clock;
    private final OwedAnswers owed = new OwedAnswers();

    ResponseCorrelator(Inbox inbox, LineClock clock) {
        this.inbox = inbox;
        this.clock = clock;
    }

    /** Records that a request was written whose last byte leaves at {@code sent}. */
    void asked(long sent) {
        owed.asked(sent);
    }

    /** The next message, if it comes by {@code deadline}, or is coming then and complete by {@code giveUp}; else null. */
    Reply by(long sent, long deadline, long giveUp) throws PortException {
        Reply answer = inbox.next(deadline);
        while (answer == null && isComing(sent) && giveUp - clock.nanos() > 0) {
            answer = inbox.next(inbox.lastByteNanos() + QUIET_NANOS); // asking again would drop the part that has come
        }
        return answer;
    }

    private boolean isComing(long sent) {
        return inbox.isReadingVersion1()
                && inbox.lastByteNanos() - sent > 0
                && clock.nanos() - inbox.lastByteNanos() < QUIET_NANOS;
    }

    /**
     * The answer to the last request, when the first message behind it has come.
     *
     * @param first that message
     */
    Reply last(Reply first, int timeoutMillis) throws PortException {
        if (owed.mayBeLate()) {
            return lastBeforeSilence(first, TimeUnit.MILLISECONDS.toNanos(timeoutMillis));
        }
        owed.answered(clock.nanos());
        return newest(first); // behind a frame that was cut comes the intact one
    }

    /** The newest message that is there already: {@code message}, unless others have come behind it. */
    Reply newest(Reply message) throws PortException {
        Reply newer = inbox.newest();
        return newer == null ? message : newer;
    }

    /** The last message before the line falls silent. */
    private Reply lastBeforeSilence(Reply first, long timeoutNanos) throws PortException {
        long now = clock.nanos();
        long giveUp = now + timeoutNanos;
        long settlingNanos = owed.settlingNanos(now, timeoutNanos);
        Reply last = first;
        while (giveUp - clock.nanos() > 0 && inbox.isReadingVersion1()) {
            long left = Math.min(inbox.lastByteNanos() + settlingNanos, giveUp) - clock.nanos();
            Reply later = inbox.next(clock.nanos() + left);
            if (later != null) {
                last = later;
            } else if (clock.nanos() - inbox.lastByteNanos() >= settlingNanos) {
                owed.settled();
                return last;
            }
        }
        return last; // the line does not rest: the next answer may be late too
    }
}
