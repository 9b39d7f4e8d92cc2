package javino.serial;

import java.time.Duration;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.IntSupplier;
import javino.PortInterruptedException;

/**
 * Opens devices one after the other, because jSerialComm keeps only the error code of the last failed opening. If a driver takes long, as
 * for Bluetooth, other openings begin after a short wait. Safe on any thread.
 */
final class DriverOpening {
    /** Replaces an error code that may belong to another opening. */
    static final int UNKNOWN_CODE = -1;

    private final ReentrantLock turn = new ReentrantLock(true);
    private final long maxWaitNanos;

    DriverOpening(Duration maxWait) {
        maxWaitNanos = maxWait.toNanos();
    }

    /**
     * @param open opens the device by its driver; returns false if the driver failed
     * @param errorCode returns the driver's error code for the failure
     * @return empty if the device is open; else the driver's error code or {@link #UNKNOWN_CODE}
     */
    OptionalInt open(String port, BooleanSupplier open, IntSupplier errorCode) throws PortInterruptedException {
        boolean alone = awaitTurn(port);
        try {
            return open.getAsBoolean()
                    ? OptionalInt.empty()
                    : OptionalInt.of(alone ? errorCode.getAsInt() : UNKNOWN_CODE);
        } finally {
            if (alone) {
                turn.unlock();
            }
        }
    }

    private boolean awaitTurn(String port) throws PortInterruptedException {
        try {
            return turn.tryLock(maxWaitNanos, TimeUnit.NANOSECONDS);
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(port);
        }
    }
}
