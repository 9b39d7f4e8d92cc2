package javino;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;

/** A lock with one condition, in the time of a line. */
final class Monitor {
    /** Longer than anything is waited for. */
    static final long FOREVER = Long.MAX_VALUE / 4;

    /** Work under the lock. */
    interface Work<T, E extends Exception> {
        T run() throws E;
    }

    /** Work under the lock without a result. */
    interface Change<E extends Exception> {
        void run() throws E;
    }

    private final Lock lock;
    private final Condition changed;
    private final LineClock clock;
    private final String port;

    /** @param port what exceptions name */
    Monitor(LineClock clock, String port) {
        this.clock = clock;
        this.port = port;
        lock = clock.newLock(false);
        changed = lock.newCondition();
    }

    /** Does {@code work} under the lock. */
    <T, E extends Exception> T get(Work<T, E> work) throws E {
        lock.lock();
        try {
            return work.run();
        } finally {
            lock.unlock();
        }
    }

    /** Makes {@code change} under the lock, and wakes who waits in {@link #await}. */
    <E extends Exception> void change(Change<E> change) throws E {
        get(() -> {
            change.run();
            changed.signalAll();
            return null;
        });
    }

    /** As {@link #get}, for work that waits. */
    <T> T getInterruptibly(Work<T, PortException> work) throws PortException {
        try {
            lock.lockInterruptibly();
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(port);
        }
        try {
            return work.run();
        } finally {
            lock.unlock();
        }
    }

    /** Waits for a change, at most {@code nanos}; may return early. The caller holds the lock. */
    void await(long nanos) throws PortInterruptedException {
        try {
            if (nanos >= FOREVER) {
                changed.await();
            } else {
                clock.await(changed, nanos);
            }
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(port);
        }
    }

    /** Does {@code work} with the lock free, which the caller holds once; then wakes who waits in {@link #await}. */
    <T> T unlocked(Work<T, PortException> work) throws PortException {
        lock.unlock();
        try {
            return work.run();
        } finally {
            lock.lock();
            changed.signalAll(); // it takes effect when the lock is free again
        }
    }
}
