package javino.link;

import java.util.concurrent.TimeUnit;
import javino.LineClock;

/** Knows whether a board may still be starting, since opening its port may have reset it. Safe on any thread. */
final class BoardStart {
    private final LineClock clock;
    private final long startedAt; // from this time on, a board that has not answered is taken to run
    private volatile boolean isReady;
    private volatile boolean hasHeard;
    private volatile boolean hasSaidHello;

    /** @param bootMillis for how many milliseconds from now the board may be starting */
    BoardStart(LineClock clock, int bootMillis) {
        this.clock = clock;
        startedAt = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(bootMillis);
        isReady = bootMillis == 0;
    }

    /** Nanoseconds for which the board may still be starting; 0 once something has come from it, or it must have started. */
    long nanosLeft() {
        return isReady ? 0 : Math.max(0, startedAt - clock.nanos());
    }

    boolean hasHeard() {
        return hasHeard;
    }

    /** Returns whether HELLO has been said, so that a board of version 2 would have answered. */
    boolean hasSaidHello() {
        return hasSaidHello;
    }

    void saidHello() {
        hasSaidHello = true;
    }

    void heard() {
        hasHeard = true;
        isReady = true;
    }

    void answered() {
        isReady = true;
    }
}
