package javino.serial;

import java.time.Duration;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.IntSupplier;
import javino.PortInterruptedException;

/**
 * Opens devices one after the other, since jSerialComm keeps one error code for the whole program, that of the last failed opening. If a
 * driver takes long, as for Bluetooth, the others wait only a moment, and are then opened at the same time. Safe on any thread.
 */
final class DriverOpening {
    /** Stands for an error code that may be that of another opening. */
    static final int UNKNOWN_CODE = -1;

    private final ReentrantLock turn = new ReentrantLock(true);
    private final long maxWaitNanos;

    /** @param maxWait the longest time that an opening waits for another */
    DriverOpening(Duration maxWait) {
        maxWaitNanos = maxWait.toNanos();
    }

    /**
     * Opens a device.
     *
     * @param open opens the device by its driver; returns false if that fails
     * @param errorCode gives the driver's error code of the failure
     * @return empty if the device is open, else the driver's error code or {@link #UNKNOWN_CODE}
     * @throws PortInterruptedException if the thread is interrupted while it waits for another opening
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
