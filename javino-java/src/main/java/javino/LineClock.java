package javino;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;

/** The clock of lines and links. The clock is passed in, so that tests of code that depends on time need not wait. */
public interface LineClock {
    /** Nanoseconds from an origin that stays the same; never goes back. Only differences mean something. */
    long nanos();

    /**
     * Waits until {@code condition} is signalled or {@code nanos} of this clock have passed; may return early. The caller holds the
     * condition's lock. Clocks other than the machine's override this.
     *
     * @throws InterruptedException if the thread is interrupted
     */
    default void await(Condition condition, long nanos) throws InterruptedException {
        condition.awaitNanos(nanos);
    }

    /**
     * Returns a new reentrant lock; {@link #await} takes only conditions of such locks. A clock of virtual time moves only while all its
     * threads wait, so it returns locks of its own kind.
     *
     * @param fair whether waiting threads get the lock in the order in which they asked for it
     */
    default Lock newLock(boolean fair) {
        return new ReentrantLock(fair);
    }

    /** Runs {@code action} when {@code nanos} of this clock have passed, on a thread of the clock's choice. The action must not wait. */
    default void schedule(long nanos, Runnable action) {
        CompletableFuture.delayedExecutor(nanos, TimeUnit.NANOSECONDS, Runnable::run)
                .execute(action);
    }

    /** The machine's steady clock. */
    static LineClock system() {
        return System::nanoTime;
    }
}
