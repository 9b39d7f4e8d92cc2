package javino;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;

/** The clock of lines and links. Tests pass a clock of their own and need not wait. */
public interface LineClock {
    /** Returns nanoseconds from a fixed origin. The value never decreases. Only differences between two values are meaningful. */
    long nanos();

    /**
     * Waits until {@code condition} is signalled or {@code nanos} of this clock have passed; may return early. The caller holds the
     * condition's lock. Every other clock than that of the machine overrides this method.
     *
     * @throws InterruptedException if the thread is interrupted
     */
    default void await(Condition condition, long nanos) throws InterruptedException {
        condition.awaitNanos(nanos);
    }

    /**
     * Returns a new reentrant lock. {@link #await} takes only conditions of locks from this method. A virtual clock overrides this
     * method: its time moves only while all its threads wait.
     *
     * @param fair whether waiting threads get the lock in the order of their requests
     */
    default Lock newLock(boolean fair) {
        return new ReentrantLock(fair);
    }

    /** Runs {@code action} after {@code nanos} of this clock, on any thread. The action must not wait. */
    default void schedule(long nanos, Runnable action) {
        CompletableFuture.delayedExecutor(nanos, TimeUnit.NANOSECONDS, Runnable::run)
                .execute(action);
    }

    /** Returns the machine's steady clock. */
    static LineClock system() {
        return System::nanoTime;
    }
}
