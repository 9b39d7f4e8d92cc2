package javino;

/**
 * Tells which of the messages that come is the answer to the last request, and waits for it.
 *
 * <p>Times are nanoseconds of the link's clock. One thread at a time.
 */
final class ResponseCorrelator {
    private static final long NANOS_PER_MILLI = 1_000_000L;
    private static final long QUIET_NANOS = Pacer.QUIET_MILLIS * NANOS_PER_MILLI;
    private static final long MIN_TIMEOUT_NANOS = 100 * NANOS_PER_MILLI;

    private final Inbox inbox;
    private final LineClock clock;
    private RoundTripTimes history = new RoundTripTimes();
    private RoundTripTimes asIfVersion2; // what is owed if the board turns out to be of version 2 and slow; null: nothing

    ResponseCorrelator(Inbox inbox, LineClock clock) {
        this.inbox = inbox;
        this.clock = clock;
    }

    /** Says that a request was written whose last byte leaves at {@code sent}. */
    void asked(long sent) {
        history.asked(sent);
    }

    /** The next message, if it comes by {@code deadline}, or is coming then and complete by {@code giveUp}; else null. */
    Reply by(long sent, long deadline, long giveUp) throws PortException {
        Reply answer = inbox.next(deadline);
        while (answer == null && isComing(sent) && giveUp - clock.nanos() > 0) {
            answer = inbox.next(inbox.lastByteNanos() + QUIET_NANOS); // asking again would drop what has come of it
        }
        return answer;
    }

    private boolean isComing(long sent) {
        return inbox.lastByteNanos() - sent > 0 && clock.nanos() - inbox.lastByteNanos() < QUIET_NANOS;
    }

    /** As {@link #by}, but null as soon as the line is silent behind more than {@code noise}. */
    Reply orDamage(long sent, long noise, long deadline, long giveUp) throws PortException {
        Reply answer = null;
        for (long now = clock.nanos(); answer == null && deadline - now > 0; now = clock.nanos()) {
            if (inbox.discardedBytes() > noise && now - inbox.lastByteNanos() >= QUIET_NANOS) {
                return null;
            }
            answer = inbox.next(Math.min(deadline - now, QUIET_NANOS) + now);
        }
        return answer != null ? answer : by(sent, deadline, giveUp);
    }

    /** Nanoseconds after which an answer is late. */
    long timeoutNanos() {
        return history.timeoutNanos(MIN_TIMEOUT_NANOS);
    }

    /** Says that nothing is owed any more. */
    void settled() {
        history.settled();
    }

    /** Says that the requests so far were of version 2, to which a version 1 board owes no answer. */
    void oweNothingInVersion1() {
        asIfVersion2 = history;
        history = new RoundTripTimes();
    }

    /** Says that it is a version 2 board that answers now, after all. */
    void oweAllInVersion2() {
        if (asIfVersion2 != null) {
            asIfVersion2.asked(clock.nanos());
            history = asIfVersion2;
            asIfVersion2 = null;
        }
    }

    /**
     * The answer to the last request, when the first message behind it has come.
     *
     * @param first that message
     */
    Reply last(Reply first, int timeoutMillis, boolean version2) throws PortException {
        if (history.mayBeLate()) {
            return lastBeforeSilence(first, timeoutMillis * NANOS_PER_MILLI, version2);
        }
        history.answered(clock.nanos());
        return newest(first); // behind a frame that was cut comes the intact one
    }

    /** The newest message that is there already: {@code message}, unless others have come behind it. */
    Reply newest(Reply message) throws PortException {
        Reply newer = inbox.newest();
        return newer == null ? message : newer;
    }

    /**
     * The last message before the board falls silent. A board of version 2 may acknowledge actions all the time, so there it is the time
     * since a message that counts, and if there is one for each request no further is due.
     */
    private Reply lastBeforeSilence(Reply first, long timeoutNanos, boolean version2) throws PortException {
        long now = clock.nanos();
        long giveUp = now + timeoutNanos;
        long settlingNanos = history.settlingNanos(now, timeoutNanos);
        Reply last = first;
        long lastAt = now;
        for (int messages = 1; giveUp - clock.nanos() > 0; ) {
            long left = Math.min((version2 ? lastAt : inbox.lastByteNanos()) + settlingNanos, giveUp) - clock.nanos();
            Reply later = inbox.next(clock.nanos() + left);
            if (later != null) {
                last = later;
                lastAt = clock.nanos();
                messages++;
            }
            boolean silent = later == null && clock.nanos() - (version2 ? lastAt : inbox.lastByteNanos()) >= settlingNanos;
            if (silent || version2 && messages >= history.owed()) {
                history.settled();
                return last;
            }
        }
        return last; // the line does not rest: the next answer may be late too
    }
}
