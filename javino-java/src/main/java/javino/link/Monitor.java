package javino.link;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import java.util.function.LongSupplier;
import javino.LineClock;
import javino.PortException;
import javino.PortInterruptedException;

/**
 * A lock under which threads wait for conditions, by a line's clock. A thread that releases the lock checks the conditions of the waiting
 * threads. The thread wakes only threads whose condition is true: a needless wake-up costs more than a check.
 */
final class Monitor {
    static final long FOREVER = Long.MAX_VALUE / 4;

    interface Work<T, E extends Exception> {
        T run() throws E;
    }

    interface Change<E extends Exception> {
        void run() throws E;
    }

    private final Lock lock;
    private final LineClock clock;
    private final String port;
    private final List<Waiter> waiters = new ArrayList<>();
    private int depth; // number of times that the holder has locked the lock

    Monitor(LineClock clock, String port) {
        this.clock = clock;
        this.port = port;
        lock = clock.newLock(false);
    }

    <T, E extends Exception> T get(Work<T, E> work) throws E {
        lock.lock();
        return run(work);
    }

    <E extends Exception> void change(Change<E> change) throws E {
        get(() -> {
            change.run();
            return null;
        });
    }

    <T> T getInterruptibly(Work<T, PortException> work) throws PortException {
        try {
            lock.lockInterruptibly();
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(port);
        }
        return run(work);
    }

    private <T, E extends Exception> T run(Work<T, E> work) throws E {
        depth++;
        try {
            return work.run();
        } finally {
            try {
                if (depth == 1) {
                    waiters.forEach(Waiter::wakeIfDue); // a condition may take the lock again
                }
            } finally {
                depth--;
                lock.unlock();
            }
        }
    }

    /**
     * Waits until {@code nanosLeft} returns 0 or less. Every thread that releases the lock calls {@code nanosLeft}, under the lock. The
     * waiting thread calls {@code nanosLeft} when the returned time has passed. {@code nanosLeft} must change nothing, and depend only on
     * time and on state that the lock guards. The caller holds the lock.
     */
    void await(LongSupplier nanosLeft) throws PortInterruptedException {
        Waiter waiter = new Waiter(nanosLeft);
        waiters.add(waiter);
        try {
            while (true) {
                long now = clock.nanos();
                long left = Math.min(nanosLeft.getAsLong(), FOREVER);
                if (left <= 0) {
                    return;
                }
                waiter.wakesAt = now + left;
                free(() -> waiter.sleep(left));
            }
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(port);
        } finally {
            waiters.remove(waiter);
        }
    }

    /** Releases the lock, does {@code work}, and takes the lock again. The caller holds the lock. */
    <T> T unlocked(Work<T, PortException> work) throws PortException {
        return free(() -> {
            lock.unlock();
            try {
                return work.run();
            } finally {
                lock.lock();
            }
        });
    }

    private <T, E extends Exception> T free(Work<T, E> work) throws E {
        waiters.forEach(Waiter::wakeIfDue);
        int held = depth;
        depth = 0;
        try {
            return work.run();
        } finally {
            depth = held;
        }
    }

    private final class Waiter {
        private final Condition woken = lock.newCondition();
        private final LongSupplier nanosLeft;
        private long wakesAt;
        private boolean isWoken = true; // also true before the thread sleeps

        Waiter(LongSupplier nanosLeft) {
            this.nanosLeft = nanosLeft;
        }

        Void sleep(long nanos) throws InterruptedException {
            isWoken = false;
            try {
                if (nanos >= FOREVER) {
                    woken.await();
                } else {
                    clock.await(woken, nanos);
                }
                return null;
            } finally {
                isWoken = true;
            }
        }

        void wakeIfDue() {
            if (!isWoken && isDue()) {
                isWoken = true;
                woken.signal();
            }
        }

        private boolean isDue() {
            long left = Math.min(nanosLeft.getAsLong(), FOREVER);
            return left <= 0 || clock.nanos() + left - wakesAt < 0;
        }
    }
}
