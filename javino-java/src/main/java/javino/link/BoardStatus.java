package javino.link;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javino.LineClock;
import javino.Protocol;
import javino.wire.Welcome;

/**
 * Tracks whether the board at the other end runs, and which version of the protocol it speaks. Opening a port may restart its board. Safe
 * on any thread. The version changes only under the line's lock.
 */
final class BoardStatus {
    private static final int NONE = -1;

    private final Monitor monitor;
    private final LineClock clock;
    private final Protocol wanted;
    private final long startedAt; // from then on the board counts as running, even without an answer
    private volatile boolean isReady;
    private volatile boolean hasHeard; // a message of version 1 has come
    private volatile boolean hasSaidHello;
    private volatile Protocol protocol;
    private volatile boolean hasLapsed; // the session lapsed in silence, so another board may be connected now
    private volatile int otherRevision = NONE; // revision of version 2 that this program cannot speak

    /** @param settings the link's settings; {@link LinkSettings#bootMillis()} begin now */
    BoardStatus(Monitor monitor, LineClock clock, LinkSettings settings) {
        this.monitor = monitor;
        this.clock = clock;
        wanted = settings.protocol();
        protocol = wanted;
        startedAt = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(settings.bootMillis());
        isReady = settings.bootMillis() == 0;
    }

    /**
     * Returns the nanoseconds for which the board may still be starting. Returns 0 if the board has sent something, or must have started.
     */
    long nanosToStart() {
        return isReady ? 0 : Math.max(0, startedAt - clock.nanos());
    }

    void answered() {
        isReady = true;
    }

    /** Records that a message of version 1 has come, so the board runs. */
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

    /** Returns whether HELLO has been sent. A board of version 2 would have answered. */
    boolean hasSaidHello() {
        return hasSaidHello;
    }

    /** Returns the version that is spoken. Returns {@link Protocol#AUTO} if the version is not known. */
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

    /** Treats the board as one of version 1. A later answer to HELLO still changes the version. */
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

    /** Records that the board speaks an unknown revision of version 2. Returns whether this revision is news. */
    boolean foundRevision(int revision) {
        boolean isNews = otherRevision != revision;
        otherRevision = revision;
        return isNews;
    }

    /** Returns why a board that answered HELLO has no session. Returns empty if there is a session, or if the board did not answer. */
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

    /** Returns whether a request or HELLO must precede the next command of version 1. */
    boolean mustAsk() {
        return !speaks2() && (mustAnswer() || protocol == Protocol.AUTO && !hasSaidHello);
    }

    /** Returns whether a command of version 1 must wait for an answer in version 1. */
    boolean mustAnswer() {
        return nanosToStart() > 0 || protocol == Protocol.AUTO && (hasHeard || hasLapsed);
    }
}
