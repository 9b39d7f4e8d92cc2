package javino;

import java.util.concurrent.TimeUnit;

/**
 * Asks and listens: what is said to a board, what of that is an answer, and whether the board runs yet.
 *
 * <p>One thread at a time, but for what says that any may call it.
 */
final class RequestChannel {
    /** What is asked of a board to find out whether it runs, and in which version. */
    private static final Frame READINESS_REQUEST = Frame.of(PerceptsRequest.ALL);

    private static final int REPEAT_MILLIS = 250;
    /** A request is sent so often at most on a line whose damage is seen. */
    private static final int TRIES = 3;
    /** Milliseconds after which an answer is late if none has been timed yet. */
    private static final int UNKNOWN_TIMEOUT_MILLIS = 60_000;

    private final Inbox inbox;
    private final FrameWriter writer;
    private final LineClock clock;
    private final RoundTripTimes times = new RoundTripTimes(UNKNOWN_TIMEOUT_MILLIS);
    private final ResponseCorrelator answers;
    private final Negotiation negotiation;
    private final long startedAt; // when a board that has not answered is taken to run
    private final int spacingMillis;
    private volatile Protocol protocol;
    private volatile boolean ready;
    private volatile boolean heard; // the board has said something
    private int sequence;
    private boolean listens; // somebody wants what the board says unasked
    private boolean forAction; // the board is asked since an action is to be sent, and nobody wants the answer
    private Reply overheard; // the newest that came meanwhile and is for who listens; null: none

    /** @param settings of which {@link LinkSettings#bootMillis()} counts from now */
    RequestChannel(Inbox inbox, FrameWriter writer, LineClock clock, LinkSettings settings) {
        this.inbox = inbox;
        this.writer = writer;
        this.clock = clock;
        answers = new ResponseCorrelator(inbox, clock, times);
        negotiation = new Negotiation(this, inbox, answers, clock, settings);
        protocol = settings.protocol();
        spacingMillis = settings.spacingMillis();
        startedAt = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(settings.bootMillis());
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

    /** Whether the board has said something. Any thread. */
    boolean hasHeard() {
        return heard;
    }

    /** Whether the board has to be asked for something before it is sent an action: see {@link #awaitStart}. Any thread. */
    boolean mustAsk() {
        return nanosUntilStarted() > 0 || protocol == Protocol.AUTO && heard;
    }

    /** Returns when the board has answered and it is known which version it speaks, or when it must have started. */
    void awaitStart() throws PortException {
        if (!mustAsk()) {
            return;
        }
        forAction = true;
        try {
            if (protocol == Protocol.AUTO) {
                negotiation.run(READINESS_REQUEST, REPEAT_MILLIS, false);
            } else {
                askUntil(startedAt, READINESS_REQUEST, REPEAT_MILLIS);
            }
        } finally {
            forAction = false;
        }
    }

    /** Writes a request and returns its answer, or null if none comes in time; repeats it while the board may be starting. */
    Reply request(Frame request, int timeoutMillis) throws PortException {
        overheard = null;
        return protocol == Protocol.AUTO
                ? negotiation.run(request, timeoutMillis, true)
                : requestAsAgreed(request, timeoutMillis);
    }

    /** As {@link #request}, in the version that is spoken, or, if that is not known yet, in turns. */
    Reply requestAsAgreed(Frame request, int timeoutMillis) throws PortException {
        long timeoutNanos = TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        long starting = nanosUntilStarted();
        if (starting > 0) {
            return askUntil(clock.nanos() + Math.max(starting, timeoutNanos), request, timeoutMillis);
        }
        if (protocol == Protocol.V2) {
            return askAgain(request, timeoutMillis);
        }
        Reply answer = inbox.next(askAsAgreed(request, timeoutMillis) + timeoutNanos);
        return answer == null ? null : completed(answer, timeoutMillis);
    }

    /** Returns when a frame of version 1 may follow what was asked in version 2. Any thread. */
    void awaitGap() throws PortException {
        writer.awaitTime(negotiation.version1From());
    }

    /** The newest message that the board sends of its own accord, or null if none comes in time. */
    Reply listen(int timeoutMillis) throws PortException {
        listens = true;
        Reply message = overheard != null
                ? overheard
                : inbox.next(clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis));
        overheard = null;
        if (message == null) {
            return null;
        }
        heard = true;
        ready = true;
        writer.answered(clock.nanos()); // who speaks is not busy with a request that nobody waits for any more
        Reply newest = answers.newest(message);
        if (protocol == Protocol.AUTO && newest.version() == Protocol.V2) {
            agreeOn(Protocol.V2);
        }
        return newest;
    }

    /** Keeps what came unasked while the board was asked for the sake of an action. */
    void overhear(Reply message) {
        if (forAction && listens) {
            overheard = message;
        }
    }

    /** Speaks this version from now on. */
    void agreeOn(Protocol version) {
        inbox.read(version);
        if (version == Protocol.V2) {
            writer.speakVersion2();
        }
        protocol = version;
    }

    /** Repeats the request until it is answered or the clock shows {@code giveUp}; null: no answer. */
    private Reply askUntil(long giveUp, Frame request, int timeoutMillis) throws PortException {
        long repeatNanos = TimeUnit.MILLISECONDS.toNanos(Math.min(timeoutMillis, REPEAT_MILLIS));
        Reply answer = null;
        for (long left = giveUp - clock.nanos(); answer == null && left > 0; left = giveUp - clock.nanos()) {
            long sent = askAsAgreed(request, timeoutMillis);
            answer = answers.by(sent, sent + Math.min(left, repeatNanos), giveUp);
        }
        return answer == null ? null : completed(answer, timeoutMillis);
    }

    /**
     * Asks a version 2 board, and again if the answer was damaged, or is later than others were. An answer to one of several requests says
     * nothing about how long the board takes, so the time that is given it is doubled until a request is answered at once.
     */
    private Reply askAgain(Frame request, int timeoutMillis) throws PortException {
        long sent = askAsAgreed(request, timeoutMillis);
        long giveUp = sent + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        for (int tries = 1; true; tries++) {
            long noise = inbox.discardedBytes();
            long timeout = tries < TRIES ? times.timeoutNanos() : Long.MAX_VALUE / 2;
            Reply answer = answers.orDamage(sent, noise, sent + Math.min(timeout, giveUp - sent), giveUp);
            if (answer != null) {
                return completed(answer, timeoutMillis);
            }
            if (giveUp - clock.nanos() <= 0) {
                return null;
            }
            if (inbox.discardedBytes() > noise) {
                answers.settled(); // that was it
            } else {
                times.timedOut();
            }
            sent = askAsAgreed(request, timeoutMillis);
        }
    }

    private long askAsAgreed(Frame request, int timeoutMillis) throws PortException {
        return protocol == Protocol.AUTO
                ? negotiation.ask(request, timeoutMillis)
                : ask(protocol, request, timeoutMillis);
    }

    /** Writes a request in this version, and returns when its last byte leaves. */
    long ask(Protocol version, Frame request, int timeoutMillis) throws PortException {
        Frame frame = request;
        if (version == Protocol.V2) {
            frame = request.toVersion2(0, sequence);
            sequence = (sequence + 1) % Frame.SEQUENCES;
        }
        long sent = write(frame, timeoutMillis, forAction && listens ? inbox::asked : inbox::clear);
        answers.asked(sent);
        return sent;
    }

    private long write(Frame frame, int timeoutMillis, FrameWriter.BeforeWrite beforeWrite) throws PortException {
        return writer.write(FrameWriter.Kind.REQUEST, frame, timeoutMillis + spacingMillis, () -> {
            beforeWrite.run();
            inbox.sends(frame);
        });
    }

    /** Brings the exchange whose first message has come to its end, and returns the answer. */
    Reply completed(Reply first, int timeoutMillis) throws PortException {
        heard = true;
        ready = true;
        if (protocol == Protocol.AUTO && first.version() == Protocol.V2) {
            agreeOn(Protocol.V2);
            answers.oweAllInVersion2();
        }
        Reply answer = answers.last(first, timeoutMillis, protocol == Protocol.V2);
        overhear(answer);
        writer.answered(clock.nanos());
        return answer;
    }
}
