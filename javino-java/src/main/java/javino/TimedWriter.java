package javino;

import java.util.Arrays;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Gives blocking writes a time limit. The operating system's write has none: it waits for as long as the far end does not read. So it is
 * done on a thread of this writer's own, which the caller waits for.
 *
 * <p>Safe on any thread; writes go out in the order in which they are called, each as a whole.
 */
final class TimedWriter {
    /** The write that has no time limit. */
    interface Target {
        /** Writes all the bytes; returns how many were written, fewer or -1 on an error. */
        int write(byte[] bytes);
    }

    private static final System.Logger LOG = System.getLogger(TimedWriter.class.getName());

    /** How a write ended. */
    enum Outcome { WRITTEN, FAILED, TOO_LATE, CLOSED }

    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private final Target target;
    private final LineClock clock;
    private Job waiting; // the next to be written
    private boolean closed;

    /**
     * @param port its name, for the thread's
     * @param clock what the time limits are of
     */
    TimedWriter(String port, Target target, LineClock clock) {
        this.target = target;
        this.clock = clock;
        Thread thread = new Thread(this::work, "write " + port);
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * Writes the bytes, waiting at most until {@code deadlineNanos} of the clock. After {@link Outcome#TOO_LATE} they have
     * not left, or are still on their way out.
     */
    Outcome write(byte[] b, int off, int len, long deadlineNanos) throws InterruptedException {
        Job job = new Job(Arrays.copyOfRange(b, off, off + len));
        lock.lockInterruptibly();
        try {
            while (waiting != null && !closed) {
                if (!awaitUntil(deadlineNanos)) {
                    return Outcome.TOO_LATE;
                }
            }
            waiting = job;
            changed.signalAll();
            while (job.outcome == null && !closed) {
                if (!awaitUntil(deadlineNanos)) {
                    return Outcome.TOO_LATE;
                }
            }
            return job.outcome != null ? job.outcome : Outcome.CLOSED;
        } finally {
            if (waiting == job) {
                waiting = null;
                changed.signalAll();
            }
            lock.unlock();
        }
    }

    /** Waits for a change; false if the time is over. */
    private boolean awaitUntil(long deadlineNanos) throws InterruptedException {
        long left = deadlineNanos - clock.nanos();
        if (left > 0) {
            clock.await(changed, left);
        }
        return left > 0;
    }

    /** Ends the thread as soon as its write returns. Calls that wait get {@link Outcome#CLOSED}. */
    void close() {
        lock.lock();
        try {
            closed = true;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    private void work() {
        Job job = next();
        while (job != null) {
            finish(job, write(job));
            job = next();
        }
    }

    private Outcome write(Job job) {
        try {
            return target.write(job.bytes) == job.bytes.length ? Outcome.WRITTEN : Outcome.FAILED;
        } catch (RuntimeException e) { // the thread must go on, or every later write would wait for it in vain
            LOG.log(System.Logger.Level.ERROR, "the driver failed", e);
            return Outcome.FAILED;
        }
    }

    private Job next() {
        lock.lock();
        try {
            while (waiting == null && !closed) {
                changed.awaitUninterruptibly();
            }
            Job job = closed ? null : waiting;
            waiting = null;
            changed.signalAll();
            return job;
        } finally {
            lock.unlock();
        }
    }

    private void finish(Job job, Outcome outcome) {
        lock.lock();
        try {
            job.outcome = outcome;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    private static final class Job {
        private final byte[] bytes;
        private Outcome outcome;

        Job(byte[] bytes) {
            this.bytes = bytes;
        }
    }
}
