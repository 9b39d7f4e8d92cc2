package javino.serial;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.time.Duration;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import javino.DriverTransport;
import javino.LineSettings;
import javino.PortException;
import javino.PortInterruptedException;

/** A serial device or a pseudo-terminal, through jSerialComm. */
final class SerialTransport extends DriverTransport {
    /** The longest wait of one driver read. The driver counts in tenths of a second. */
    private static final int SLICE_MILLIS = 100;

    private static final long SLICE_NANOS = TimeUnit.MILLISECONDS.toNanos(SLICE_MILLIS);
    private static final long MILLI_NANOS = TimeUnit.MILLISECONDS.toNanos(1);
    private static final int READ_END_MILLIS = 2_000;
    private static final int CLOSE_MILLIS = 2_000;
    /** The shortest interval between two checks for bytes, right after the line was in use. */
    private static final long POLL_NANOS = 250_000L;
    /** The longest interval, for a line that has long been quiet. Unasked messages are rare, and each check takes time. */
    private static final long MAX_POLL_NANOS = TimeUnit.MILLISECONDS.toNanos(1);
    /** The interval is the time since the last byte divided by this number. */
    private static final int STILL_SHARE = 8;

    /** The longest wait of a close for written bytes to leave the driver. The close then drops the rest. */
    private static final long LINGER_NANOS = TimeUnit.MILLISECONDS.toNanos(100);

    private static final long MAX_LINGER_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    /**
     * Bytes that any driver certainly takes. Used for drivers that do not count waiting bytes, such as pseudo-terminals. A
     * pseudo-terminal of Linux holds four times this number. One of macOS holds more than this number at 9600 baud.
     */
    private static final int SMALLEST_BUFFER = 1024;

    private static final DriverOpening OPENING = new DriverOpening(Duration.ofSeconds(1));

    /** Held while the driver reads, so no other thread closes the driver. */
    final ReentrantLock reading = new ReentrantLock();

    private final SerialPort port;
    private volatile long lingerUntil = System.nanoTime();
    private volatile long stillSince = System.nanoTime();
    /** Whether the driver has shown that it counts waiting bytes. */
    private volatile boolean countsWaiting;

    private SerialTransport(SerialPort port, String name, LineSettings line) {
        super(name, line);
        this.port = port;
    }

    static SerialTransport open(String name, LineSettings line) throws PortException {
        return open(SerialDevice.of(name), line);
    }

    static SerialTransport open(SerialDevice device, LineSettings line) throws PortException {
        try {
            return new SerialTransport(openDriver(device, line), device.name(), line);
        } catch (SerialPortInvalidPortException e) {
            throw SerialPortErrors.noSuchPort(device, SerialPorts.names());
        } catch (LinkageError e) {
            throw SerialPortErrors.noNativeLibrary(device.name(), e);
        }
    }

    private static SerialPort openDriver(SerialDevice device, LineSettings line) throws PortException {
        if (!device.exists()) {
            // jSerialComm would look for the device elsewhere
            throw SerialPortErrors.noSuchPort(device, SerialPorts.names());
        }
        SerialPort port = SerialPort.getCommPort(device.hasNode() ? device.canonicalAddress() : device.path());
        port.setComPortParameters(line.baud(), 8, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
        port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED);
        port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, SLICE_MILLIS, 0);
        OptionalInt error = OPENING.open(device.name(), port::openPort, port::getLastErrorCode);
        if (error.isPresent()) {
            throw SerialPortErrors.cannotOpen(device, error.getAsInt(), SerialPorts.names());
        }
        return port;
    }

    @Override
    protected int readFromDriver(byte[] b, int off, int len, long nanos) throws PortException {
        boolean slice =
                nanos >= SLICE_NANOS - MILLI_NANOS; // 1 ms less, so a read of almost a slice counts as a whole slice
        int count = readNow(b, off, len, slice);
        if (count > 0) {
            stillSince = System.nanoTime();
        } else if (!slice && nanos > 0) {
            LockSupport.parkNanos(Math.min(nanos, pollNanos(System.nanoTime() - stillSince)));
        }
        return count;
    }

    /**
     * Returns the time until the next check for bytes, on a line that has been quiet for {@code stillNanos}. At 50 Hz the checks would
     * cost more than all other work.
     */
    static long pollNanos(long stillNanos) {
        return Math.min(Math.max(POLL_NANOS, stillNanos / STILL_SHARE), MAX_POLL_NANOS);
    }

    private int readNow(byte[] b, int off, int len, boolean wait) throws PortException {
        awaitReading();
        try {
            requireLine();
            int count = wait ? len : Math.min(len, port.bytesAvailable());
            if (count > 0) {
                count = port.readBytes(b, count, off);
            }
            if (count < 0) {
                throw lost(lossWhenRefused());
            }
            return count;
        } finally {
            reading.unlock();
        }
    }

    /** Takes the lock {@link #reading}. An interrupt ends the wait. If the lock is free, an interrupted thread gets it. */
    private void awaitReading() throws PortInterruptedException {
        try {
            if (!reading.tryLock()) {
                reading.lockInterruptibly();
            }
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(name());
        }
    }

    @Override
    protected int writeToDriver(byte[] bytes) {
        int count = port.writeBytes(bytes, bytes.length);
        if (!countsWaiting) {
            countsWaiting = port.bytesAwaitingWrite() > 0;
        }
        stillSince = System.nanoTime();
        lingerUntil = stillSince + LINGER_NANOS;
        return count;
    }

    @Override
    protected boolean hasRoom(long unread) {
        return countsWaiting ? port.bytesAwaitingWrite() == 0 : unread <= SMALLEST_BUFFER - LONGEST_FRAME;
    }

    @Override
    protected String lossWhenRefused() {
        return "its device was unplugged, or the far end closed";
    }

    @Override
    protected void closeDriver() {
        boolean interrupted = Thread.interrupted(); // an interrupted thread must also close the port in order
        port.setComPortTimeouts(SerialPort.TIMEOUT_NONBLOCKING, 0, 0); // ends a read that waits
        linger();
        boolean readingEnded = false;
        try {
            readingEnded = reading.tryLock(READ_END_MILLIS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            interrupted = true;
        }
        if (!readingEnded) {
            warnGivenUp("reading");
        } else {
            if (!closePort()) {
                warnGivenUp("closing");
            }
            reading.unlock();
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Closes the port and so ends a waiting write. Returns false if the driver takes too long. */
    private boolean closePort() {
        Thread closing = new Thread(port::closePort, "close " + name());
        closing.setDaemon(true);
        closing.start();
        try {
            closing.join(CLOSE_MILLIS);
            return !closing.isAlive();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return true;
        }
    }

    private void warnGivenUp(String call) {
        System.getLogger(SerialTransport.class.getName())
                .log(
                        System.Logger.Level.WARNING,
                        "port " + name() + " is given up as it is: its driver does not return from " + call);
    }

    /** Waits until the written bytes have left the driver, at most {@link #MAX_LINGER_NANOS}. Does nothing if the device is lost. */
    private void linger() {
        long now = System.nanoTime();
        long deadline = now + MAX_LINGER_NANOS;
        while (!isLost() && deadline - now > 0 && (lingerUntil - now > 0 || port.bytesAwaitingWrite() > 0)) {
            LockSupport.parkNanos(POLL_NANOS);
            now = System.nanoTime();
        }
    }
}
