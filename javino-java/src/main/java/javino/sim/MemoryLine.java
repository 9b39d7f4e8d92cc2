package javino.sim;

import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Lock;
import javino.LineClock;
import javino.LineSettings;
import javino.PortException;
import javino.PortGoneException;
import javino.PortInterruptedException;
import javino.PortTimeoutException;
import javino.Transport;

/**
 * A line in memory with two ends, each a {@link Transport}. Simulated boards and tests use it in place of a device.
 *
 * <p>On an unlimited line, bytes arrive at once. On a paced line, each byte takes its time at the line's rate. The directions are
 * independent. The line holds {@value #CAPACITY} unread bytes in each direction. A further write waits.
 *
 * <p>If one end is closed, the other end can still read the bytes that are on their way. After these bytes, the line is gone for both
 * ends. If the line is unplugged, the line is gone at once for both ends. All methods are safe on any thread.
 */
public final class MemoryLine {
    /** The most unread bytes that the line holds in each direction. */
    public static final int CAPACITY = 4096;

    private final Lock lock;
    private final String name;
    private final LineSettings line;
    private final LineClock clock;
    private final String doubt; // see Transport.doubt; null: the usual one
    private final End computer;
    private final End board;
    private volatile String end; // reason for the end of the line, or null

    private MemoryLine(String name, LineSettings line, long byteNanos, LineClock clock, String doubt) {
        this.name = name;
        this.line = line;
        this.clock = clock;
        this.doubt = doubt;
        lock = clock.newLock(false);
        MemoryDirection toBoard = new MemoryDirection(CAPACITY, byteNanos, lock, clock.nanos());
        MemoryDirection toComputer = new MemoryDirection(CAPACITY, byteNanos, lock, clock.nanos());
        computer = new End(toComputer, toBoard);
        board = new End(toBoard, toComputer);
    }

    /** Returns a line on which bytes arrive at once. */
    public static MemoryLine unlimited(String name, LineSettings line) {
        return unlimited(name, line, LineClock.system());
    }

    /** Returns a line on which bytes arrive at once, and whose waits use {@code clock}. */
    public static MemoryLine unlimited(String name, LineSettings line, LineClock clock) {
        return new MemoryLine(name, line, 0, clock, null);
    }

    /** Returns a line on which every byte takes {@link LineSettings#byteNanos()}. */
    public static MemoryLine paced(String name, LineSettings line) {
        return paced(name, line, LineClock.system());
    }

    /** Returns a line to a board about whose silence {@code doubt} says more than {@link Transport#doubt} usually does. */
    static MemoryLine paced(String name, LineSettings line, String doubt) {
        return new MemoryLine(name, line, line.byteNanos(), LineClock.system(), doubt);
    }

    /** Returns a line on which every byte takes {@link LineSettings#byteNanos()} of {@code clock}. */
    public static MemoryLine paced(String name, LineSettings line, LineClock clock) {
        return new MemoryLine(name, line, line.byteNanos(), clock, null);
    }

    /** Returns the end that a program opens. */
    public Transport computer() {
        return computer;
    }

    /** Returns the board's end. */
    public Transport board() {
        return board;
    }

    /** Unplugs the line. Both ends are gone, and the bytes on the line are lost. */
    public void unplug() {
        end("it was unplugged", computer.in, board.in);
    }

    /**
     * Closes the board's end.
     *
     * @param why completes the sentence "port x is gone: ..."
     */
    void closeBoard(String why) {
        end(why, board.in);
    }

    /** Ends the line and empties the given directions. If the line has ended already, keeps the first reason. */
    private void end(String why, MemoryDirection... emptied) {
        lock.lock();
        try {
            if (end == null) {
                end = why;
            }
            List.of(emptied).forEach(MemoryDirection::clear);
            computer.in.changed.signalAll();
            board.in.changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /** Returns whether an end is closed or the line is unplugged. */
    public boolean isGone() {
        return end != null;
    }

    private void requireLine() throws PortGoneException {
        if (end != null) {
            throw new PortGoneException(name, "port " + name + " is gone: " + end);
        }
    }

    private void await(MemoryDirection direction, long nanos) throws PortException {
        try {
            clock.await(direction.changed, nanos);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            requireLine();
            throw new PortInterruptedException(name);
        }
    }

    final class End implements Transport {
        private final MemoryDirection in;
        private final MemoryDirection out;

        End(MemoryDirection in, MemoryDirection out) {
            this.in = in;
            this.out = out;
        }

        @Override
        public String name() {
            return name;
        }

        @Override
        public LineSettings line() {
            return line;
        }

        @Override
        public String doubt() {
            return doubt != null ? doubt : Transport.super.doubt();
        }

        @Override
        public int read(byte[] b, int off, int len, int timeoutMillis) throws PortException {
            long deadline = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
            lock.lock();
            try {
                while (true) {
                    long now = clock.nanos();
                    int count = in.take(b, off, len, now);
                    if (count > 0) {
                        in.changed.signalAll();
                        return count;
                    }
                    if (in.isEmpty()) {
                        requireLine();
                    }
                    if (deadline - now <= 0) {
                        return 0;
                    }
                    await(in, Math.min(deadline - now, in.nanosUntilReady(now)));
                }
            } finally {
                lock.unlock();
            }
        }

        @Override
        public void write(byte[] b, int off, int len, int timeoutMillis) throws PortException {
            long deadline = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
            int written = 0;
            lock.lock();
            try {
                while (true) {
                    requireLine();
                    long now = clock.nanos();
                    int count = out.put(b, off + written, len - written, now);
                    written += count;
                    if (count > 0) {
                        out.changed.signalAll();
                    }
                    if (written == len) {
                        return;
                    }
                    if (deadline - now <= 0) {
                        throw new PortTimeoutException(
                                name,
                                "port " + name + " took " + written + " of " + len + " bytes within " + timeoutMillis
                                        + " ms; nobody reads at the far end");
                    }
                    await(out, deadline - now);
                }
            } finally {
                lock.unlock();
            }
        }

        @Override
        public boolean isWritableNow(long unread) {
            lock.lock();
            try {
                return end == null && out.room() >= LONGEST_FRAME;
            } finally {
                lock.unlock();
            }
        }

        /** Returns whether {@code count} bytes have been read from this end and no further byte is on its way to it. */
        boolean isRead(long count) {
            lock.lock();
            try {
                return in.isEmpty() && in.taken() == count;
            } finally {
                lock.unlock();
            }
        }

        @Override
        public void close() {
            end("it was closed", in);
        }
    }
}
