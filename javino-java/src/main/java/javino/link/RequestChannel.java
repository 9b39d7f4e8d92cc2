package javino.link;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Lock;
import javino.Frame;
import javino.LineClock;
import javino.PerceptsRequest;
import javino.PortException;
import javino.Protocol;

/**
 * Asks and listens in the version that the board speaks, and finds that version out. One thread at a time, except for methods marked "Any
 * thread".
 */
final class RequestChannel {
    /** The request that finds out whether a board runs, and which version it speaks. */
    private static final Frame READINESS_REQUEST = Frame.of(PerceptsRequest.ALL);

    private static final Frame KINDS_REQUEST = Frame.of(PerceptsRequest.KINDS);
    private static final int REQUEST_BYTES = 50;

    private final SessionLine line;
    private final LineClock clock;
    private final BoardStart start;
    private final Version1Requests version1;
    private final Negotiation negotiation;
    private final Lock negotiating;
    private final long byteNanos;
    private volatile boolean isListening;

    RequestChannel(SessionLine line, FrameWriter writer, LineClock clock, LinkSettings settings) {
        this.line = line;
        this.clock = clock;
        start = line.start();
        version1 = new Version1Requests(line.inbox(), writer, clock, start);
        negotiation = new Negotiation(line, writer, version1, start, clock, settings);
        negotiating = clock.newLock(false);
        byteNanos = settings.line().byteNanos();
    }

    /**
     * Returns when the board has answered and it is known which version it speaks, or when it must have started. A board that is taken to
     * run is sent no request, only HELLO.
     */
    void awaitStart() throws PortException {
        if (!line.mustAsk()) {
            return;
        }
        version1.askForAction(true);
        try {
            if (line.protocol() == Protocol.AUTO && !line.mustAnswer()) {
                sayHello();
            } else if (line.protocol() == Protocol.AUTO) {
                negotiateOnce();
            } else {
                version1.askUntil(clock.nanos() + start.nanosLeft(), READINESS_REQUEST, Version1Requests.REPEAT_MILLIS);
            }
        } finally {
            version1.askForAction(false);
        }
    }

    /**
     * Like {@link #awaitStart}, but only if another thread {@linkplain #listen listens} and only HELLO has to be said: that thread reads
     * the answer, so an action need not wait until it has heard a message. Any thread.
     *
     * @return whether HELLO has been said
     */
    boolean sayHelloToListener() throws PortException {
        if (!isListening || line.protocol() != Protocol.AUTO || line.mustAnswer()) {
            return false;
        }
        sayHello();
        return true;
    }

    private void sayHello() throws PortException {
        negotiating.lock();
        try {
            if (!start.hasSaidHello()) {
                negotiation.sayHello(Version1Requests.REPEAT_MILLIS);
            }
        } finally {
            start.saidHello();
            negotiating.unlock();
        }
    }

    private Reply negotiate(Frame request, int timeoutMillis) throws PortException {
        negotiating.lock();
        try {
            Reply answer = negotiation.run(request, timeoutMillis);
            start.saidHello();
            return answer;
        } finally {
            negotiating.unlock();
        }
    }

    /** Negotiates for a command. If that fails, later commands go out without asking again. */
    private void negotiateOnce() throws PortException {
        try {
            negotiate(READINESS_REQUEST, Version1Requests.REPEAT_MILLIS);
        } finally {
            start.saidHello();
        }
    }

    /**
     * Writes a request and returns its answer, or null if none comes in time; repeats it while the board may be starting, and if the answer
     * is damaged. Returns null as well if the board turns out to speak version 2, in which only percepts are requested.
     */
    Reply request(Frame request, int timeoutMillis) throws PortException {
        if (line.isVersion2()) {
            return requestInVersion2(request, timeoutMillis);
        }
        Reply answer = null;
        if (line.protocol() == Protocol.AUTO) {
            answer = negotiate(request, timeoutMillis);
        }
        if (answer == null && line.protocol() == Protocol.V1) {
            answer = version1.request(request, timeoutMillis);
        }
        return answer == null && line.isVersion2() ? requestInFoundVersion2(request, timeoutMillis) : answer;
    }

    /** Asks a board of version 2 for the kinds of its percepts; null: it speaks another version, or gives no answer in time. */
    Reply requestKinds(int timeoutMillis) throws PortException {
        return line.isVersion2() ? requestInVersion2(KINDS_REQUEST, timeoutMillis) : null;
    }

    /** Asks a board that has just been found to speak version 2: if its session has not begun, this waits as long again for that. */
    private Reply requestInFoundVersion2(Frame request, int timeoutMillis) throws PortException {
        return requestInVersion2(request, line.isOpen() ? timeoutMillis : 2L * timeoutMillis);
    }

    private Reply requestInVersion2(Frame request, long waitMillis) throws PortException {
        if (!PerceptsRequest.isIn(request.text())) {
            return null;
        }
        long wait = Math.max(
                line.isOpen() ? 0 : start.nanosLeft(),
                TimeUnit.MILLISECONDS.toNanos(waitMillis) + REQUEST_BYTES * byteNanos);
        Reply answer = line.request(request.text().substring(PerceptsRequest.ALL.length()), clock.nanos() + wait);
        if (answer != null) {
            start.answered();
        }
        return answer;
    }

    /** The newest message that the board sends of its own accord, or null if none comes in time. */
    Reply listen(int timeoutMillis) throws PortException {
        long deadline = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        isListening = true;
        try {
            Reply message = line.isVersion2() ? null : version1.listen(deadline);
            return message == null && line.isVersion2() ? line.listen(deadline) : message;
        } finally {
            isListening = false;
        }
    }

    /** Reads until the clock shows {@code deadline}, and keeps the messages that come. */
    void watch(long deadline) throws PortException {
        line.await(() -> false, deadline, true);
    }
}
