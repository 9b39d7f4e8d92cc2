package javino.link;

import java.util.concurrent.TimeUnit;
import javino.Frame;
import javino.LineClock;
import javino.PortException;
import javino.wire.WireFrame;

/**
 * Finds out which version a board speaks: sends HELLO twice, then a request in version 1. While the board may be starting, repeats HELLO
 * and the request until an answer comes. A board of version 1 ignores HELLO. A board of version 2 that missed HELLO during its start may
 * answer the request in version 1. A board that may be starting therefore gets HELLO once more after its answer. If stray bytes came,
 * they may contain a damaged WELCOME, so the board gets several HELLOs.
 * <p>A board in a session ignores a frame of version 1 that closely follows other bytes. A frame of version 1 therefore follows HELLO
 * only after the time for WELCOME. Not thread-safe.
 */
final class Negotiation {
    private static final long HELLO_NANOS = TimeUnit.MILLISECONDS.toNanos(60);
    private static final int HELLO_BYTES = 20;
    private static final int HELLOS_BEHIND_NOISE = 5;
    private static final long REPEAT_NANOS = TimeUnit.MILLISECONDS.toNanos(Version1Requests.REPEAT_MILLIS);

    private final SharedLine line;
    private final FrameWriter writer;
    private final Version1Requests version1;
    private final BoardStatus board;
    private final LineClock clock;
    private final long helloNanos;
    private boolean hasNoise; // stray bytes came in place of WELCOME

    Negotiation(
            SharedLine line, FrameWriter writer, Version1Requests version1, LineClock clock, LinkSettings settings) {
        this.line = line;
        this.writer = writer;
        this.version1 = version1;
        board = line.board();
        this.clock = clock;
        helloNanos = Math.max(HELLO_NANOS, HELLO_BYTES * settings.line().byteNanos());
    }

    /**
     * Finds out the version. Gives up after {@code timeoutMillis}, but not before the board must have started.
     *
     * @return the answer to {@code request} in version 1; null if none came
     */
    Reply run(Frame request, int timeoutMillis) throws PortException {
        long timeoutNanos = TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        boolean mayBeStarting = board.nanosToStart() > 0;
        long giveUp = clock.nanos() + Math.max(board.nanosToStart(), timeoutNanos);
        hasNoise = false;
        if (sayHello(timeoutMillis)) {
            return null;
        }
        if (board.hasHeard() || line.inbox().hasMessage()) {
            board.agreeOnVersion1();
            return null;
        }
        while (true) {
            long sent = version1.ask(request, timeoutMillis);
            long wait = mayBeStarting ? Math.min(timeoutNanos, REPEAT_NANOS - helloNanos) : timeoutNanos;
            Reply first = version1.awaitAnswer(sent, sent + wait, Math.max(giveUp, sent + timeoutNanos));
            if (first != null) {
                Reply answer = version1.completed(first, timeoutMillis);
                if (isWelcomed(hasNoise ? HELLOS_BEHIND_NOISE : mayBeStarting ? 1 : 0, timeoutMillis)) {
                    return null;
                }
                board.agreeOnVersion1();
                return answer;
            }
            if (board.speaks2() || giveUp - clock.nanos() <= 0 || isWelcomed(timeoutMillis)) {
                return null;
            }
        }
    }

    /** Sends HELLO. If no WELCOME comes, sends HELLO once more. Returns whether WELCOME has come. */
    boolean sayHello(int timeoutMillis) throws PortException {
        return isWelcomed(2, timeoutMillis);
    }

    private boolean isWelcomed(int hellos, int timeoutMillis) throws PortException {
        for (int i = 0; i < hellos; i++) {
            if (isWelcomed(timeoutMillis)) {
                return true;
            }
        }
        return false;
    }

    private boolean isWelcomed(int timeoutMillis) throws PortException {
        long left = writer.write(
                FrameWriter.Kind.ACTION,
                WireFrame.OVERHEAD,
                timeoutMillis,
                () -> board.speaks2() ? null : line.session().hello()); // a further HELLO would end the session
        boolean isWelcomed = line.await(board::speaks2, left + helloNanos, true);
        hasNoise |= !isWelcomed && line.inbox().strayBytes().count() > 0;
        return isWelcomed;
    }
}
