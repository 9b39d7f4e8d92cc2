package javino;

/**
 * Asks and listens: what is said to a board, what of that is an answer, and whether the board runs yet.
 *
 * <p>One thread at a time, but for {@link #nanosUntilStarted}.
 */
final class Exchange {
    /** What is asked of a board to find out whether it runs: every board answers it and none acts on it. */
    private static final Frame READINESS_REQUEST = Frame.of("getPercepts");

    private static final long NANOS_PER_MILLI = 1_000_000L;
    private static final int REPEAT_MILLIS = 250;
    private static final long QUIET_NANOS = LineSchedule.QUIET_MILLIS * NANOS_PER_MILLI;

    private final AnswerHistory history = new AnswerHistory();
    private final Inbox inbox;
    private final FrameWriter writer;
    private final LineClock clock;
    private final long startedAt; // when a board that has not answered is taken to run
    private volatile boolean ready;

    /** @param bootMillis milliseconds from now in which the board may not have started yet; 0: it runs */
    Exchange(Inbox inbox, FrameWriter writer, LineClock clock, int bootMillis) {
        this.inbox = inbox;
        this.writer = writer;
        this.clock = clock;
        startedAt = clock.nanos() + bootMillis * NANOS_PER_MILLI;
        ready = bootMillis == 0;
    }

    /** Nanoseconds for which the board may still be starting; 0 when it has said something, or must have started. Any thread. */
    long nanosUntilStarted() {
        return ready ? 0 : Math.max(0, startedAt - clock.nanos());
    }

    /** Returns when the board has answered, or must have started. */
    void awaitStart() throws PortException {
        if (nanosUntilStarted() > 0) {
            askUntil(startedAt, READINESS_REQUEST, REPEAT_MILLIS);
        }
    }

    /** Writes a request and returns its answer, or null if none comes in time; repeats it while the board may be starting. */
    Frame request(Frame request, int timeoutMillis) throws PortException {
        long timeoutNanos = timeoutMillis * NANOS_PER_MILLI;
        long starting = nanosUntilStarted();
        if (starting > 0) {
            return askUntil(clock.nanos() + Math.max(starting, timeoutNanos), request, timeoutMillis);
        }
        Frame answer = inbox.next(ask(request, timeoutMillis) + timeoutNanos);
        return answer == null ? null : completed(answer, timeoutMillis);
    }

    /** The newest message that the board sends of its own accord, or null if none comes in time. */
    Frame listen(int timeoutMillis) throws PortException {
        Frame message = inbox.next(clock.nanos() + timeoutMillis * NANOS_PER_MILLI);
        if (message == null) {
            return null;
        }
        ready = true;
        writer.answered(clock.nanos()); // who speaks is not busy with a request that nobody waits for any more
        return newest(message);
    }

    /** Repeats the request until it is answered or the clock shows {@code giveUp}; null: no answer. */
    private Frame askUntil(long giveUp, Frame request, int timeoutMillis) throws PortException {
        long repeatNanos = Math.min(timeoutMillis, REPEAT_MILLIS) * NANOS_PER_MILLI;
        Frame answer = null;
        for (long left = giveUp - clock.nanos(); answer == null && left > 0; left = giveUp - clock.nanos()) {
            long sent = ask(request, timeoutMillis);
            answer = inbox.next(sent + Math.min(left, repeatNanos));
            while (answer == null && answerIsComing(sent) && giveUp - clock.nanos() > 0) {
                answer = inbox.next(inbox.lastByteNanos() + QUIET_NANOS); // asking again would drop what has come of it
            }
        }
        return answer == null ? null : completed(answer, timeoutMillis);
    }

    private boolean answerIsComing(long sent) {
        return inbox.lastByteNanos() - sent > 0 && clock.nanos() - inbox.lastByteNanos() < QUIET_NANOS;
    }

    /** Writes a request, and returns when its last byte leaves. */
    private long ask(Frame request, int timeoutMillis) throws PortException {
        long sent = writer.write(FrameWriter.Kind.REQUEST, request, timeoutMillis, inbox::clear);
        history.asked(sent);
        return sent;
    }

    /** Brings the exchange whose first message has come to its end. */
    private Frame completed(Frame answer, int timeoutMillis) throws PortException {
        ready = true;
        Frame last = answer;
        if (history.mayBeLate()) {
            last = lastBeforeSilence(answer, timeoutMillis * NANOS_PER_MILLI);
        } else {
            history.answered(clock.nanos());
            last = newest(answer); // behind a frame that was cut comes the intact one
        }
        writer.answered(clock.nanos());
        return last;
    }

    /** The newest message that is there already: {@code message}, unless others have come behind it. */
    private Frame newest(Frame message) throws PortException {
        Frame newer = inbox.newest();
        return newer == null ? message : newer;
    }

    private Frame lastBeforeSilence(Frame first, long timeoutNanos) throws PortException {
        long now = clock.nanos();
        long giveUp = now + timeoutNanos;
        long settlingNanos = history.settlingNanos(now, timeoutNanos);
        Frame last = first;
        while (giveUp - clock.nanos() > 0) {
            long left = Math.min(inbox.lastByteNanos() + settlingNanos - clock.nanos(), giveUp - clock.nanos());
            Frame later = inbox.next(clock.nanos() + left);
            if (later != null) {
                last = later;
            } else if (clock.nanos() - inbox.lastByteNanos() >= settlingNanos) {
                history.settled();
                return last;
            }
        }
        return last; // the line does not rest: the next answer may be late too
    }
}
