package javino;

import java.util.concurrent.TimeUnit;

/**
 * Tells which of the messages that come is the answer to the last request, and waits for it.
 *
 * <p>Times are nanoseconds of the link's clock. One thread at a time.
 */
final class ResponseCorrelator {
    private static final long QUIET_NANOS = TimeUnit.MILLISECONDS.toNanos(Pacer.QUIET_MILLIS);

    private final Inbox inbox;
    private final LineClock clock;
    private final RoundTripTimes times;
    private OwedAnswers owed;
    private OwedAnswers asIfVersion2; // what is owed if the board turns out to be of version 2 and slow; null: nothing

    /** @param times records how long answers take */
    ResponseCorrelator(Inbox inbox, LineClock clock, RoundTripTimes times) {
        this.times = times;
        owed = new OwedAnswers(times);
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

    /** Records that nothing is owed any more. */
    void settled() {
        owed.settled();
    }

    /** Records that the requests so far were of version 2, to which a version 1 board owes no answer. */
    void oweNothingInVersion1() {
        asIfVersion2 = owed;
        owed = new OwedAnswers(times);
    }

    /** Records that it is a version 2 board that answers now, after all. */
    void oweAllInVersion2() {
        if (asIfVersion2 != null) {
            asIfVersion2.asked(clock.nanos());
            owed = asIfVersion2;
            asIfVersion2 = null;
        }
    }

    /**
     * The answer to the last request, when the first message behind it has come.
     *
     * @param first that message
     */
    Reply last(Reply first, int timeoutMillis, boolean version2) throws PortException {
        if (owed.mayBeLate()) {
            return lastBeforeSilence(first, TimeUnit.MILLISECONDS.toNanos(timeoutMillis), version2);
        }
        owed.answered(clock.nanos());
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
        long settlingNanos = owed.settlingNanos(now, timeoutNanos);
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
            boolean silent =
                    later == null && clock.nanos() - (version2 ? lastAt : inbox.lastByteNanos()) >= settlingNanos;
            if (silent || version2 && messages >= owed.count()) {
                owed.settled();
                return last;
            }
        }
        return last; // the line does not rest: the next answer may be late too
    }
}
