package javino.serial;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.time.Duration;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import javino.LineClock;
import javino.LineSettings;
import javino.PortException;
import javino.PortGoneException;
import javino.PortInterruptedException;
import javino.PortTimeoutException;
import javino.TimedWriter;
import javino.Transport;

/** A serial device, or a pseudo-terminal that stands for one, through jSerialComm. */
final class SerialTransport implements Transport {
    /** How long one read of the driver waits: it counts in tenths of a second. */
    private static final int SLICE_MILLIS = 100;
    private static final long SLICE_NANOS = TimeUnit.MILLISECONDS.toNanos(SLICE_MILLIS);
    private static final long MILLI_NANOS = TimeUnit.MILLISECONDS.toNanos(1);
    /** How long closing waits for a read that should have ended. */
    private static final int READ_END_MILLIS = 2_000;
    /** How often the driver is asked when less than a slice is left. */
    private static final long POLL_NANOS = 250_000L;
    /** How long what was written may be on its way out of the driver, which drops it when it closes the port. */
    private static final long LINGER_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
    private static final long MAX_LINGER_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    private static final DriverOpening OPENING = new DriverOpening(Duration.ofSeconds(1));

    private final ReentrantLock reading = new ReentrantLock(); // held while the driver reads, so that it is not closed under it
    private final SerialPort port;
    private final String name;
    private final LineSettings line;
    private final TimedWriter writer;
    private final AtomicBoolean closed = new AtomicBoolean();
    private volatile long lingerUntil = System.nanoTime();
    private volatile boolean gone;

    private SerialTransport(SerialPort port, String name, LineSettings line) {
        this.port = port;
        this.name = name;
        this.line = line;
        writer = new TimedWriter(name, bytes -> port.writeBytes(bytes, bytes.length), LineClock.system());
    }

    static SerialTransport open(String name, LineSettings line) throws PortException {
        return open(SerialDevice.of(name), line);
    }

    static SerialTransport open(SerialDevice device, LineSettings line) throws PortException {
        try {
            SerialTransport transport = new SerialTransport(openDriver(device, line), device.name(), line);
            transport.writer.start();
            return transport;
        } catch (SerialPortInvalidPortException e) {
            throw SerialPortErrors.noSuchPort(device, SerialPorts.names());
        } catch (LinkageError e) {
            throw SerialPortErrors.noNativeLibrary(device.name(), e);
        }
    }

    private static SerialPort openDriver(SerialDevice device, LineSettings line) throws PortException {
        if (!device.exists()) {
            throw SerialPortErrors.noSuchPort(device, SerialPorts.names()); // jSerialComm would look for the name elsewhere
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
    public String name() {
        return name;
    }

    @Override
    public LineSettings line() {
        return line;
    }

    @Override
    public int read(byte[] b, int off, int len, int timeoutMillis) throws PortException {
        long deadline = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        while (true) {
            long left = deadline - System.nanoTime();
            boolean slice = left >= SLICE_NANOS - MILLI_NANOS; // so that a wait of one slice is one
            int count = readNow(b, off, len, slice);
            if (count > 0 || left <= 0) {
                return count;
            }
            if (!slice) {
                LockSupport.parkNanos(Math.min(left, POLL_NANOS));
            }
            if (Thread.currentThread().isInterrupted()) {
                throw new PortInterruptedException(name);
            }
        }
    }

    /** Reads what there is; if nothing is, waits a slice for it or not at all. */
    private int readNow(byte[] b, int off, int len, boolean wait) throws PortException {
        reading.lock();
        try {
            requireOpen();
            int count = wait ? len : Math.min(len, port.bytesAvailable());
            if (count > 0) {
                count = port.readBytes(b, count, off);
            }
            if (count < 0) {
                throw broken();
            }
            return count;
        } finally {
            reading.unlock();
        }
    }

    @Override
    public void write(byte[] b, int off, int len, int timeoutMillis) throws PortException {
        requireOpen();
        long deadline = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        try {
            switch (writer.write(b, off, len, deadline)) {
                case WRITTEN -> lingerUntil = System.nanoTime() + LINGER_NANOS;
                case TOO_LATE -> throw new PortTimeoutException(name, "port " + name + " did not take " + len + " bytes within "
                        + timeoutMillis + " ms; the device does not read");
                default -> throw broken();
            }
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(name);
        }
    }

    private void requireOpen() throws PortGoneException {
        if (closed.get() || gone) {
            throw noLine();
        }
    }

    /** What is to be thrown when the driver reports an error: on an open line that means that the device is not there any more. */
    private PortGoneException broken() {
        if (!closed.get()) {
            gone = true;
        }
        return noLine();
    }

    private PortGoneException noLine() {
        return new PortGoneException(name, "port " + name + " is gone: "
                + (gone ? "its device was unplugged, or the far end closed" : "it was closed"));
    }

    @Override
    public void close() {
        if (closed.getAndSet(true)) {
            return;
        }
        writer.close();
        port.setComPortTimeouts(SerialPort.TIMEOUT_NONBLOCKING, 0, 0); // ends a read that waits
        linger();
        if (!readingEnds()) {
            System.getLogger(SerialTransport.class.getName()).log(System.Logger.Level.WARNING,
                    "port " + name + " is given up as it is: its driver does not return from reading");
            return;
        }
        try {
            port.closePort(); // ends a write that waits
        } finally {
            reading.unlock();
        }
    }

    /** Takes the reading's lock, for which a device that knows no time limits may let one wait for ever. */
    private boolean readingEnds() {
        boolean interrupted = Thread.interrupted();
        try {
            return reading.tryLock(READ_END_MILLIS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            interrupted = true;
            return false;
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    /** Waits until what was written has left the driver, but not for a device that takes no more. */
    private void linger() {
        boolean interrupted = Thread.interrupted(); // a thread that is interrupted closes the port with the same care
        long deadline = System.nanoTime() + MAX_LINGER_NANOS;
        long now = System.nanoTime();
        while (!gone && deadline - now > 0 && (lingerUntil - now > 0 || port.bytesAwaitingWrite() > 0)) {
            LockSupport.parkNanos(POLL_NANOS);
            now = System.nanoTime();
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
