package javino;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;

/**
 * Takes frames to a line, one at a time and in the order in which they are asked for, each when the {@link Pacer} lets it. So a
 * request waits for the actions that were waiting before it, and for no others.
 *
 * <p>Safe on any thread; no lock is held while bytes are written.
 */
final class FrameWriter {
    /** What a frame is for: the pacer treats the two differently. */
    enum Kind { ACTION, REQUEST }

    /** What is done after a frame's turn has come and right before it is written. */
    interface BeforeWrite {
        void run() throws PortException;
    }

    private static final long NANOS_PER_MILLI = 1_000_000L;

    private final Lock lock;
    private final Condition changed;
    private final Deque<Object> turns = new ArrayDeque<>(); // the first is being written, or is the next
    private final Transport transport;
    private final LineClock clock;
    private final Pacer pacer;
    private String end; // why the line is gone; null while it is there

    FrameWriter(Transport transport, Pacer pacer, LineClock clock) {
        this.transport = transport;
        this.pacer = pacer;
        this.clock = clock;
        lock = clock.newLock(false);
        changed = lock.newCondition();
    }

    /**
     * Waits for the frame's turn and writes it.
     *
     * @param timeoutMillis milliseconds to wait at most for the turn, and again for the driver
     * @return when its last byte leaves the line, by the clock
     * @throws PortTimeoutException if its turn did not come in time, and then nothing was written; or if the driver did not take it
     */
    long write(Kind kind, Frame frame, int timeoutMillis, BeforeWrite beforeWrite) throws PortException {
        byte[] bytes = frame.toBytes();
        Object turn = new Object();
        try {
            awaitTurn(turn, kind, bytes.length, timeoutMillis);
            beforeWrite.run();
            return writeNow(kind, bytes, timeoutMillis);
        } finally {
            endTurn(turn);
        }
    }

    private void awaitTurn(Object turn, Kind kind, int bytes, int timeoutMillis) throws PortException {
        lock();
        try {
            turns.add(turn);
            long due = clock.nanos();
            long deadline = due + timeoutMillis * NANOS_PER_MILLI;
            while (true) {
                requireLine();
                long now = clock.nanos();
                long wait = turns.peek() != turn ? Long.MAX_VALUE
                        : kind == Kind.ACTION ? pacer.nanosUntilAction(bytes, now) : pacer.nanosUntilRequest(due, now);
                if (wait == 0) {
                    return;
                }
                if (deadline - now <= 0) {
                    throw new PortTimeoutException(transport.name(), "port " + transport.name() + " had no time for a message of " + bytes
                            + " bytes within " + timeoutMillis + " ms; the line is busy with those before it");
                }
                await(Math.min(wait, deadline - now));
            }
        } finally {
            lock.unlock();
        }
    }

    private long writeNow(Kind kind, byte[] bytes, int timeoutMillis) throws PortException {
        long start = clock.nanos();
        long sent = start;
        try {
            transport.write(bytes, 0, bytes.length, timeoutMillis);
        } finally {
            lock.lock(); // also of a write that failed some bytes may have left
            try {
                long now = clock.nanos();
                sent = kind == Kind.ACTION ? pacer.wroteAction(bytes.length, start, now) : pacer.wroteRequest(bytes.length, start, now);
            } finally {
                lock.unlock();
            }
        }
        return sent;
    }

    private void endTurn(Object turn) {
        lock.lock();
        try {
            turns.remove(turn);
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /** Waits until the clock shows {@code nanos}. */
    void awaitTime(long nanos) throws PortException {
        lock();
        try {
            for (long left = nanos - clock.nanos(); left > 0; left = nanos - clock.nanos()) {
                requireLine();
                await(left);
            }
        } finally {
            lock.unlock();
        }
    }

    /** Says that {@code bytes} have been read at {@code now}. */
    void received(int bytes, long now) {
        lock.lock();
        try {
            pacer.received(bytes, now);
        } finally {
            lock.unlock();
        }
    }

    /** Says that a message is complete, the answer to the last request if one is awaited: actions go out that waited for it. */
    void answered(long now) {
        lock.lock();
        try {
            pacer.answered(now);
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /** Says that the board speaks version 2. */
    void speakVersion2() {
        lock.lock();
        try {
            pacer.speakVersion2();
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /** Says that the line is gone: who waits here, or comes later, gets a {@link PortGoneException} with {@code why}. */
    void end(String why) {
        lock.lock();
        try {
            if (end == null) {
                end = why;
                changed.signalAll();
            }
        } finally {
            lock.unlock();
        }
    }

    /** Whether the line is still there, as far as it is known. */
    boolean hasLine() {
        lock.lock();
        try {
            return end == null;
        } finally {
            lock.unlock();
        }
    }

    /** Does nothing on a line that is there; else throws with the reason that {@link #end} was told first. */
    void requireLine() throws PortGoneException {
        lock.lock();
        try {
            if (end != null) {
                throw new PortGoneException(transport.name(), end);
            }
        } finally {
            lock.unlock();
        }
    }

    private void lock() throws PortInterruptedException {
        try {
            lock.lockInterruptibly();
        } catch (InterruptedException e) {
            throw interrupted();
        }
    }

    private void await(long nanos) throws PortInterruptedException {
        try {
            clock.await(changed, nanos);
        } catch (InterruptedException e) {
            throw interrupted();
        }
    }

    private PortInterruptedException interrupted() {
        return PortInterruptedException.remarking(transport.name());
    }
}
