package javino;

/**
 * Asks and listens: what is said to a board, what of that is an answer, whether the board runs yet, and which version it speaks.
 *
 * <p>One thread at a time, but for what says that any may call it.
 */
final class Exchange {
    /** What is asked of a board to find out whether it runs, and in which version: every board answers it and none acts on it. */
    private static final Frame READINESS_REQUEST = Frame.of("getPercepts");

    private static final long NANOS_PER_MILLI = 1_000_000L;
    private static final int REPEAT_MILLIS = 250;
    private static final long QUIET_NANOS = LineSchedule.QUIET_MILLIS * NANOS_PER_MILLI;
    private static final long LEAST_PATIENCE_NANOS = 100 * NANOS_PER_MILLI;
    /** A request is sent so often at most on a line whose damage is seen. */
    private static final int TRIES = 3;
    private static final int MOST_BACKOFF = 4;

    private final Inbox inbox;
    private final FrameWriter writer;
    private final LineClock clock;
    private final Negotiation negotiation;
    private final long startedAt; // when a board that has not answered is taken to run
    private volatile Protocol protocol;
    private volatile boolean ready;
    private volatile boolean heard; // the board has said something
    private int sequence;
    private int backoff;
    private AnswerHistory history = new AnswerHistory();
    private AnswerHistory asIfVersion2; // what is owed if the board turns out to be of version 2 and slow; null: nothing

    /** @param settings of which {@link LinkSettings#bootMillis()} counts from now */
    Exchange(Inbox inbox, FrameWriter writer, LineClock clock, LinkSettings settings) {
        this.inbox = inbox;
        this.writer = writer;
        this.clock = clock;
        negotiation = new Negotiation();
        protocol = settings.protocol();
        startedAt = clock.nanos() + settings.bootMillis() * NANOS_PER_MILLI;
        ready = settings.bootMillis() == 0;
    }

    /** The version that is spoken; {@link Protocol#AUTO}: it is not known yet. Any thread. */
    Protocol protocol() {
        return protocol;
    }

    /** Nanoseconds for which the board may still be starting; 0 when it has said something, or must have started. Any thread. */
    long nanosUntilStarted() {
        return ready ? 0 : Math.max(0, startedAt - clock.nanos());
    }

    /** Whether the board has to be asked for something before it is sent an action: see {@link #awaitStart}. Any thread. */
    boolean mustAsk() {
        return nanosUntilStarted() > 0 || protocol == Protocol.AUTO && heard;
    }

    /** Returns when the board has answered and it is known which version it speaks, or when it must have started. */
    void awaitStart() throws PortException {
        if (mustAsk()) {
            if (protocol == Protocol.AUTO) {
                negotiation.run(READINESS_REQUEST, REPEAT_MILLIS, false);
            } else {
                askUntil(startedAt, READINESS_REQUEST, REPEAT_MILLIS);
            }
        }
    }

    /** Writes a request and returns its answer, or null if none comes in time; repeats it while the board may be starting. */
    Message request(Frame request, int timeoutMillis) throws PortException {
        return protocol == Protocol.AUTO ? negotiation.run(request, timeoutMillis, true) : requestAsAgreed(request, timeoutMillis);
    }

    private Message requestAsAgreed(Frame request, int timeoutMillis) throws PortException {
        long timeoutNanos = timeoutMillis * NANOS_PER_MILLI;
        long starting = nanosUntilStarted();
        if (starting > 0) {
            return askUntil(clock.nanos() + Math.max(starting, timeoutNanos), request, timeoutMillis);
        }
        if (protocol == Protocol.V2) {
            return askAgain(request, timeoutMillis);
        }
        Message answer = inbox.next(ask(request, timeoutMillis) + timeoutNanos);
        return answer == null ? null : completed(answer, timeoutMillis);
    }

    /** Returns when a frame of version 1 may follow what was asked in version 2. Any thread. */
    void awaitGap() throws PortException {
        writer.awaitTime(negotiation.version1From);
    }

    /** The newest message that the board sends of its own accord, or null if none comes in time. */
    Message listen(int timeoutMillis) throws PortException {
        Message message = inbox.next(clock.nanos() + timeoutMillis * NANOS_PER_MILLI);
        if (message == null) {
            return null;
        }
        heard = true;
        ready = true;
        writer.answered(clock.nanos()); // who speaks is not busy with a request that nobody waits for any more
        Message newest = newest(message);
        if (protocol == Protocol.AUTO && newest.version() == 2) {
            agreeOn(Protocol.V2);
        }
        return newest;
    }

    private void agreeOn(Protocol version) {
        inbox.read(version);
        if (version == Protocol.V2) {
            writer.boardIsVersion2();
        }
        protocol = version;
    }

    /** Repeats the request until it is answered or the clock shows {@code giveUp}; null: no answer. */
    private Message askUntil(long giveUp, Frame request, int timeoutMillis) throws PortException {
        long repeatNanos = Math.min(timeoutMillis, REPEAT_MILLIS) * NANOS_PER_MILLI;
        Message answer = null;
        for (long left = giveUp - clock.nanos(); answer == null && left > 0; left = giveUp - clock.nanos()) {
            long sent = ask(request, timeoutMillis);
            answer = answerBy(sent, sent + Math.min(left, repeatNanos), giveUp);
        }
        return answer == null ? null : completed(answer, timeoutMillis);
    }

    /**
     * Asks a version 2 board, and again if the answer was damaged, or is later than others were. An answer to one of several requests says
     * nothing about how long the board takes, so the time that is given it is doubled until a request is answered at once.
     */
    private Message askAgain(Frame request, int timeoutMillis) throws PortException {
        long sent = ask(request, timeoutMillis);
        long giveUp = sent + timeoutMillis * NANOS_PER_MILLI;
        for (int tries = 1; true; tries++) {
            long noise = inbox.noise();
            long patience = tries < TRIES ? history.patienceNanos(LEAST_PATIENCE_NANOS) << backoff : Long.MAX_VALUE / 2;
            Message answer = answerOrDamage(sent, noise, sent + Math.min(patience, giveUp - sent), giveUp);
            if (answer != null) {
                backoff = tries == 1 ? 0 : backoff;
                return completed(answer, timeoutMillis);
            }
            if (giveUp - clock.nanos() <= 0) {
                return null;
            }
            if (inbox.noise() > noise) {
                history.settled(); // that was it
            } else {
                backoff = Math.min(backoff + 1, MOST_BACKOFF);
            }
            sent = ask(request, timeoutMillis);
        }
    }

    /** As {@link #answerBy}, but null as soon as the line is silent behind more than {@code noise}. */
    private Message answerOrDamage(long sent, long noise, long deadline, long giveUp) throws PortException {
        Message answer = null;
        for (long now = clock.nanos(); answer == null && deadline - now > 0; now = clock.nanos()) {
            if (inbox.noise() > noise && now - inbox.lastByteNanos() >= QUIET_NANOS) {
                return null;
            }
            answer = inbox.next(Math.min(deadline - now, QUIET_NANOS) + now);
        }
        return answer != null ? answer : answerBy(sent, deadline, giveUp);
    }

    /** The answer, if it comes by {@code deadline}, or is coming then and complete by {@code giveUp}; else null. */
    private Message answerBy(long sent, long deadline, long giveUp) throws PortException {
        Message answer = inbox.next(deadline);
        while (answer == null && answerIsComing(sent) && giveUp - clock.nanos() > 0) {
            answer = inbox.next(inbox.lastByteNanos() + QUIET_NANOS); // asking again would drop what has come of it
        }
        return answer;
    }

    private boolean answerIsComing(long sent) {
        return inbox.lastByteNanos() - sent > 0 && clock.nanos() - inbox.lastByteNanos() < QUIET_NANOS;
    }

    /** Writes a request, and returns when its last byte leaves. */
    private long ask(Frame request, int timeoutMillis) throws PortException {
        return protocol == Protocol.AUTO ? negotiation.ask(request, timeoutMillis) : ask(protocol, request, timeoutMillis);
    }

    private long ask(Protocol version, Frame request, int timeoutMillis) throws PortException {
        Frame frame = request;
        if (version == Protocol.V2) {
            frame = request.toVersion2(0, sequence);
            sequence = (sequence + 1) % Frame.SEQUENCES;
        }
        long sent = writer.write(FrameWriter.Kind.REQUEST, frame, timeoutMillis, inbox::clear);
        history.asked(sent);
        return sent;
    }

    /** Brings the exchange whose first message has come to its end. */
    private Message completed(Message answer, int timeoutMillis) throws PortException {
        heard = true;
        ready = true;
        if (protocol == Protocol.AUTO && answer.version() == 2) {
            agreeOn(Protocol.V2);
            if (asIfVersion2 != null) {
                asIfVersion2.asked(clock.nanos());
                history = asIfVersion2;
            }
        }
        Message last = answer;
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
    private Message newest(Message message) throws PortException {
        Message newer = inbox.newest();
        return newer == null ? message : newer;
    }

    /**
     * The last message before the board falls silent. A board of version 2 may acknowledge actions all the time, so there it is the time
     * since a message that counts, and if there is one for each request no further is due.
     */
    private Message lastBeforeSilence(Message first, long timeoutNanos) throws PortException {
        long now = clock.nanos();
        long giveUp = now + timeoutNanos;
        long settlingNanos = history.settlingNanos(now, timeoutNanos);
        Message last = first;
        long lastAt = now;
        for (int messages = 1; giveUp - clock.nanos() > 0; ) {
            boolean version2 = protocol == Protocol.V2;
            long left = Math.min((version2 ? lastAt : inbox.lastByteNanos()) + settlingNanos, giveUp) - clock.nanos();
            Message later = inbox.next(clock.nanos() + left);
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

    /**
     * Finds out which version a board speaks. It is asked in version 2, twice in case the line damages one; a version 1 board discards that.
     * If there is no answer it is left a time in which boards in the field forget what they have begun to receive, and asked in version 1.
     *
     * <p>A version 2 board that was starting when it was asked in version 2 answers the request of version 1, in version 1. So one that did not
     * answer the first of these, or had something else to say before, is asked in version 2 once more, now that it runs. A board
     * that runs is asked in version 2 at one time only, and a board that starts at one more. What is not noticed is a version 2 board that
     * starts in silence after the last probe and in less than the gap behind it; it is spoken to in version 1, which works as well.
     */
    private final class Negotiation {
        private static final int PROBES = 2;
        /** So many if bytes come back, which may be a damaged answer. */
        private static final int MOST_PROBES = 5;
        private static final long PROBE_NANOS = 60 * NANOS_PER_MILLI;
        /** Boards in the field drop a frame 300 ms after its first byte. */
        private static final long GAP_NANOS = 310 * NANOS_PER_MILLI;
        /** While a board is starting, every so many requests one is of version 2, for a board that knows nothing else. */
        private static final int CYCLE = 4;

        private boolean probed;
        private int asked;
        private volatile long version1From = clock.nanos();

        /** As {@link Exchange#request}; {@code answered} says whether the answer must be fresh. */
        Message run(Frame request, int timeoutMillis, boolean answered) throws PortException {
            boolean runs = heard;
            Message answer = null;
            if (!probed || runs) {
                probed = true;
                answer = probe(request, timeoutMillis);
            }
            if (answer == null && !runs) {
                boolean starting = nanosUntilStarted() > 0;
                answer = requestAsAgreed(request, timeoutMillis);
                if (answer == null && starting) {
                    return probe(request, timeoutMillis); // the board may know nothing else
                }
                runs = asked == 1 && inbox.noise() == 0;
                if (answer == null || protocol != Protocol.AUTO) {
                    return answer;
                }
                if (runs) {
                    agreeOn(Protocol.V1);
                    return answer;
                }
                answer = probe(request, timeoutMillis);
            }
            if (answer != null) {
                return answer;
            }
            agreeOn(Protocol.V1);
            return answered ? requestAsAgreed(request, timeoutMillis) : null;
        }

        /** Writes a request while the version is not known. */
        long ask(Frame request, int timeoutMillis) throws PortException {
            asked++;
            return asked % CYCLE == 0 ? askVersion2(request, timeoutMillis) : askVersion1(request, timeoutMillis);
        }

        private long askVersion1(Frame request, int timeoutMillis) throws PortException {
            awaitGap();
            return Exchange.this.ask(Protocol.V1, request, timeoutMillis);
        }

        private long askVersion2(Frame request, int timeoutMillis) throws PortException {
            long sent = Exchange.this.ask(Protocol.V2, request, timeoutMillis);
            version1From = sent + GAP_NANOS;
            return sent;
        }

        private Message probe(Frame request, int timeoutMillis) throws PortException {
            int most = PROBES;
            for (int probes = 1; probes <= most; probes++) {
                long sent = askVersion2(request, timeoutMillis);
                long deadline = sent + (probes < most ? PROBE_NANOS : GAP_NANOS);
                Message answer = answerBy(sent, deadline, sent + REPEAT_MILLIS * NANOS_PER_MILLI);
                if (answer != null && answer.version() == 2) {
                    return completed(answer, timeoutMillis);
                }
                if (answer == null && inbox.lastByteNanos() - sent > 0) {
                    most = MOST_PROBES;
                }
            }
            asIfVersion2 = history;
            history = new AnswerHistory(); // a version 1 board owes no answer to that
            return null;
        }
    }
}
