package javino.sim;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import javino.LineClock;

/** The lock of a {@link FakeBoard}. Threads wait for changes of the board's state. Safe on any thread. */
final class FakeBoardMonitor {
    private static final long POLL_NANOS = TimeUnit.MILLISECONDS.toNanos(1);

    private final LineClock clock;
    private final Lock lock;
    private final Condition changed;

    FakeBoardMonitor(LineClock clock) {
        this.clock = clock;
        lock = clock.newLock(false);
        changed = lock.newCondition();
    }

    <T> T locked(Supplier<T> work) {
        lock.lock();
        try {
            T result = work.get();
            changed.signalAll();
            return result;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Waits until {@code reached} is true. Calls {@code reached} under the lock about every millisecond: its result may depend on state
     * that the lock does not guard.
     *
     * @param what completes "interrupted while ..."
     * @return false if {@code reached} is still false after {@code timeoutMillis}
     * @throws AssertionError if the thread is interrupted; the thread stays marked as interrupted
     */
    boolean await(BooleanSupplier reached, int timeoutMillis, String what) {
        lock.lock();
        try {
            long end = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
            while (!reached.getAsBoolean()) {
                long left = end - clock.nanos();
                if (left <= 0) {
                    return false;
                }
                clock.await(changed, Math.min(left, POLL_NANOS));
            }
            return true;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError("interrupted while " + what, e);
        } finally {
            lock.unlock();
        }
    }

    /** Waits while {@code held} is true. Returns whether there was a wait. */
    boolean awaitWhile(BooleanSupplier held) throws InterruptedException {
        lock.lockInterruptibly();
        try {
            boolean waited = held.getAsBoolean();
            while (held.getAsBoolean()) {
                changed.await();
            }
            return waited;
        } finally {
            lock.unlock();
        }
    }
}
