package javino;

import java.util.concurrent.locks.Condition;

/** The time that lines and links go by. It is passed in, so that what depends on time can be tried without waiting for it. */
public interface LineClock {
    /** Nanoseconds from an origin that stays the same; never goes back. Only differences mean something. */
    long nanos();

    /**
     * Waits until {@code condition} is signalled or {@code nanos} of this clock have passed; may return early. The caller holds
     * the condition's lock.
     *
     * @throws InterruptedException if the thread is interrupted
     */
    void await(Condition condition, long nanos) throws InterruptedException;

    /** The machine's steady clock. */
    static LineClock system() {
        return SystemLineClock.INSTANCE;
    }
}
