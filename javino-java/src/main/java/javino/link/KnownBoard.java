package javino.link;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javino.LineClock;
import javino.Protocol;
import javino.wire.Welcome;

/**
 * Knows whether the board at the other end runs, and its version of the protocol. A board may still be starting when its port is opened.
 * Safe on any thread; the version changes under the line's lock.
 */
final class KnownBoard {
    private static final int NONE = -1;

    private final Monitor monitor;
    private final LineClock clock;
    private final Protocol wanted;
    private final long startedAt; // from this time on, the board counts as running even without an answer
    private volatile boolean isReady;
    private volatile boolean hasHeard; // in version 1
    private volatile boolean hasSaidHello;
    private volatile Protocol protocol;
    private volatile boolean hasLapsed; // the board fell silent in version 2, so another board may be in its place
    private volatile int otherRevision = NONE; // the revision of version 2 that the board speaks

    /** @param settings the link's settings; {@link LinkSettings#bootMillis()} count from now */
    KnownBoard(Monitor monitor, LineClock clock, LinkSettings settings) {
        this.monitor = monitor;
        this.clock = clock;
        wanted = settings.protocol();
        protocol = wanted;
        startedAt = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(settings.bootMillis());
        isReady = settings.bootMillis() == 0;
    }

    /** Nanoseconds for which the board may still be starting; 0: the board has sent something, or must have started. */
    long nanosToStart() {
        return isReady ? 0 : Math.max(0, startedAt - clock.nanos());
    }

    void answered() {
        isReady = true;
    }

    /** Records that the board has sent something in version 1, so that it runs. */
    void heard() {
        hasHeard = true;
        isReady = true;
    }

    boolean hasHeard() {
        return hasHeard;
    }

    void saidHello() {
        hasSaidHello = true;
    }

    /** Returns whether HELLO has been sent: a board of version 2 would have answered. */
    boolean hasSaidHello() {
        return hasSaidHello;
    }

    /** The version that is spoken; {@link Protocol#AUTO}: it is not known yet, or not known any more. */
    Protocol protocol() {
        return protocol;
    }

    boolean speaks2() {
        return protocol == Protocol.V2;
    }

    boolean maySpeak2() {
        return wanted != Protocol.V1;
    }

    boolean mustSpeak2() {
        return wanted == Protocol.V2;
    }

    boolean hasLapsed() {
        return hasLapsed;
    }

    /** Treats the board as one of version 1 from now on, unless it answers a HELLO after all. */
    void agreeOnVersion1() {
        monitor.change(() -> {
            hasLapsed = false;
            protocol = protocol == Protocol.AUTO ? Protocol.V1 : protocol;
        });
    }

    void foundVersion2() {
        protocol = Protocol.V2;
        hasLapsed = false;
    }

    void sessionBegan() {
        foundVersion2();
        otherRevision = NONE;
    }

    void lapsed() {
        hasLapsed = true;
        protocol = mustSpeak2() ? Protocol.V2 : Protocol.AUTO;
    }

    /** Records that the board speaks a revision of version 2 that this program does not know; returns whether that was new. */
    boolean foundRevision(int revision) {
        boolean isNews = otherRevision != revision;
        otherRevision = revision;
        return isNews;
    }

    /** The reason why a board that answered HELLO has no session; empty: it has a session, or did not answer. */
    Optional<String> noSession() {
        int revision = otherRevision;
        if (revision == NONE) {
            return Optional.empty();
        }
        return Optional.of(
                revision < Welcome.REVISION
                        ? "the board speaks an older draft of version 2 of Javino, which is not spoken any more; upload its "
                                + "sketch again with the library of this version of ARGO (ArgoJavino, or the Python package javino)"
                        : "the board speaks revision " + revision
                                + " of version 2 of Javino, and this program only revision " + Welcome.REVISION
                                + "; use a newer version of ARGO");
    }

    /** Returns whether the board must be asked for something before it gets a command of version 1. */
    boolean mustAsk() {
        return !speaks2() && (mustAnswer() || protocol == Protocol.AUTO && !hasSaidHello);
    }

    /** Returns whether a command of version 1 has to wait for an answer: WELCOME is not enough. */
    boolean mustAnswer() {
        return nanosToStart() > 0 || protocol == Protocol.AUTO && (hasHeard || hasLapsed);
    }
}
