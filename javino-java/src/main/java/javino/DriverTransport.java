package javino;

import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * A transport over a driver whose calls block. A read calls the driver until bytes have come or the time limit is reached. A driver's
 * write has no time limit, so a thread of this transport writes. If the driver certainly takes the bytes at once, the caller's thread
 * writes instead.
 */
public abstract class DriverTransport implements Transport {
    private final String name;
    private final LineSettings line;
    private final TimedWriter writer;
    private final AtomicBoolean closed = new AtomicBoolean();
    private volatile String loss; // null while the device can be reached

    /** Creates a transport for the open port {@code name}. */
    protected DriverTransport(String name, LineSettings line) {
        this.name = name;
        this.line = line;
        writer = new TimedWriter(name, this::writeToDriver);
    }

    /**
     * Reads the bytes that have arrived.
     *
     * @param nanos the longest time to wait for a byte; the driver may wait less; 0 or less: no wait
     * @return number of bytes read; 0 if none have arrived
     */
    protected abstract int readFromDriver(byte[] b, int off, int len, long nanos) throws PortException;

    /** Writes all the bytes without a time limit. Returns the number of bytes written. If the device has gone, returns fewer or -1. */
    protected abstract int writeToDriver(byte[] bytes);

    /**
     * Returns whether {@link #writeToDriver} certainly takes a frame at once if no other write is in progress; see
     * {@link #isWritableNow}.
     */
    protected boolean hasRoom(long unread) {
        return false;
    }

    /** Closes the device. Reads and writes that wait for the device then end. Called once. */
    protected abstract void closeDriver();

    /** Returns why the driver refused a read or a write. The text completes "port x is gone: ...". */
    protected abstract String lossWhenRefused();

    @Override
    public final String name() {
        return name;
    }

    @Override
    public final LineSettings line() {
        return line;
    }

    @Override
    public final int read(byte[] b, int off, int len, int timeoutMillis) throws PortException {
        long deadline = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        while (true) {
            requireLine();
            long left = deadline - System.nanoTime();
            int count = readFromDriver(b, off, len, left);
            if (count > 0 || left <= 0) {
                return count;
            }
            if (Thread.currentThread().isInterrupted()) {
                throw new PortInterruptedException(name);
            }
        }
    }

    @Override
    public final void write(byte[] b, int off, int len, int timeoutMillis) throws PortException {
        requireLine();
        try {
            TimedWriter.Outcome outcome = timeoutMillis == 0
                    ? writer.writeHere(Arrays.copyOfRange(b, off, off + len))
                    : writer.write(b, off, len, timeoutMillis);
            if (outcome == TimedWriter.Outcome.TOO_LATE) {
                throw new PortTimeoutException(
                        name,
                        "port " + name + " did not take " + len + " bytes within " + timeoutMillis
                                + " ms; the far end does not read");
            }
            if (outcome != TimedWriter.Outcome.WRITTEN) {
                throw lost(lossWhenRefused());
            }
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(name);
        }
    }

    @Override
    public final boolean isWritableNow(long unread) {
        return !closed.get() && loss == null && !writer.isWriting() && hasRoom(unread);
    }

    /**
     * Records {@code why} as the reason for the loss of the device, unless a reason is recorded already. Returns the exception to throw.
     */
    protected final PortGoneException lost(String why) {
        if (!closed.get() && loss == null) {
            loss = why;
        }
        return new PortGoneException(name, "port " + name + " is gone: " + (loss != null ? loss : "it was closed"));
    }

    protected final boolean isLost() {
        return loss != null;
    }

    /** @throws PortGoneException if this transport is closed, or its device has gone */
    protected final void requireLine() throws PortGoneException {
        if (closed.get() || loss != null) {
            throw lost(loss);
        }
    }

    @Override
    public final void close() {
        if (!closed.getAndSet(true)) {
            writer.close();
            closeDriver();
        }
    }
}
