package javino.link;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Lock;
import javino.Frame;
import javino.LineClock;
import javino.PerceptsRequest;
import javino.PortException;
import javino.Protocol;

/**
 * Finds out which version the board speaks, and asks and listens in that version. Not thread-safe, except for methods marked "Any
 * thread".
 */
final class RequestChannel {
    private static final Frame READINESS_REQUEST = Frame.of(PerceptsRequest.ALL);

    private static final Frame KINDS_REQUEST = Frame.of(PerceptsRequest.KINDS);
    private static final int REQUEST_BYTES = 50;

    private final SharedLine line;
    private final LineClock clock;
    private final BoardStatus board;
    private final Version2Session session;
    private final Version1Requests version1;
    private final Negotiation negotiation;
    private final Lock negotiating;
    private final long byteNanos;
    private volatile boolean isListening;

    RequestChannel(SharedLine line, FrameWriter writer, LineClock clock, LinkSettings settings) {
        this.line = line;
        this.clock = clock;
        board = line.board();
        session = line.session();
        version1 = new Version1Requests(line.inbox(), writer, clock, board);
        negotiation = new Negotiation(line, writer, version1, clock, settings);
        negotiating = clock.newLock(false);
        byteNanos = settings.line().byteNanos();
    }

    /**
     * Waits until the board's answer has shown its version, or until the board must have started. A board that counts as running gets
     * only HELLO.
     */
    void awaitStart() throws PortException {
        if (!board.mustAsk()) {
            return;
        }
        version1.askForAction(true);
        try {
            if (board.protocol() == Protocol.AUTO && !board.mustAnswer()) {
                sayHello();
            } else if (board.protocol() == Protocol.AUTO) {
                negotiate(READINESS_REQUEST, Version1Requests.REPEAT_MILLIS);
            } else {
                version1.askUntil(
                        clock.nanos() + board.nanosToStart(), READINESS_REQUEST, Version1Requests.REPEAT_MILLIS);
            }
        } finally {
            board.saidHello(); // even after a failure, so waiting commands then go out without a request
            version1.askForAction(false);
        }
    }

    /**
     * Like {@link #awaitStart}, for the case that another thread {@linkplain #listen listens} and only HELLO is needed. The listening
     * thread reads the answer. Any thread.
     * @return whether HELLO has been sent
     */
    boolean sayHelloToListener() throws PortException {
        if (!isListening || board.protocol() != Protocol.AUTO || board.mustAnswer()) {
            return false;
        }
        sayHello();
        return true;
    }

    private void sayHello() throws PortException {
        negotiating.lock();
        try {
            if (!board.hasSaidHello()) {
                negotiation.sayHello(Version1Requests.REPEAT_MILLIS);
            }
        } finally {
            board.saidHello();
            negotiating.unlock();
        }
    }

    private Reply negotiate(Frame request, int timeoutMillis) throws PortException {
        negotiating.lock();
        try {
            Reply answer = negotiation.run(request, timeoutMillis);
            board.saidHello();
            return answer;
        } finally {
            negotiating.unlock();
        }
    }

    /**
     * Sends a request and returns its answer. Repeats the request while the board may be starting, and if the answer is damaged. Returns
     * null if no answer comes in time. Also returns null if the board speaks version 2 and the request is not for percepts.
     */
    Reply request(Frame request, int timeoutMillis) throws PortException {
        if (board.speaks2()) {
            return requestInVersion2(request, timeoutMillis);
        }
        Reply answer = null;
        if (board.protocol() == Protocol.AUTO) {
            answer = negotiate(request, timeoutMillis);
        }
        if (answer == null && board.protocol() == Protocol.V1) {
            answer = version1.request(request, timeoutMillis);
        }
        return answer == null && board.speaks2() // opening a session may take the time once more
                ? requestInVersion2(request, session.isOpen() ? timeoutMillis : 2L * timeoutMillis)
                : answer;
    }

    /**
     * Asks a board of version 2 for the kinds of its percepts. Returns null if the board speaks another version, or does not answer in
     * time.
     */
    Reply requestKinds(int timeoutMillis) throws PortException {
        return board.speaks2() ? requestInVersion2(KINDS_REQUEST, timeoutMillis) : null;
    }

    private Reply requestInVersion2(Frame request, long waitMillis) throws PortException {
        if (!PerceptsRequest.isIn(request.text())) {
            return null;
        }
        long wait = Math.max(
                session.isOpen() ? 0 : board.nanosToStart(),
                TimeUnit.MILLISECONDS.toNanos(waitMillis) + REQUEST_BYTES * byteNanos);
        long deadline = clock.nanos() + wait;
        line.inbox().look(); // drops earlier messages
        session.request(request.text().substring(PerceptsRequest.ALL.length()));
        try {
            line.await(() -> session.answer() != null || !board.speaks2(), deadline, true);
        } finally {
            session.cancelRequest();
        }
        Reply answer = session.answer();
        if (answer != null) {
            board.answered();
        }
        return answer;
    }

    /** Returns the newest message that the board sends on its own, or null if none comes in time. */
    Reply listen(int timeoutMillis) throws PortException {
        long deadline = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        isListening = true;
        try {
            Reply message = board.speaks2() ? null : version1.listen(deadline);
            if (message == null && board.speaks2()) {
                line.await(() -> session.hasHeard() || !board.speaks2(), deadline, true);
                message = session.takeHeard();
            }
            return message;
        } finally {
            isListening = false;
        }
    }

    /** Reads until {@code deadline}, and keeps the messages that come. */
    void watch(long deadline) throws PortException {
        line.await(() -> false, deadline, true);
    }
}
