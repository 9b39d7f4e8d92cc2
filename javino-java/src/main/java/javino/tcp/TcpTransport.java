package javino.tcp;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.ReentrantLock;
import javino.LineSettings;
import javino.PortException;
import javino.PortFaultException;
import javino.PortGoneException;
import javino.PortInterruptedException;
import javino.PortTimeoutException;
import javino.Transport;

/** A TCP connection to a board on the network, or to a serial server with a board behind it. */
final class TcpTransport implements Transport {
    private static final System.Logger LOG = System.getLogger(TcpTransport.class.getName());
    private static final long NANOS_PER_MILLI = 1_000_000L;
    private static final int DRAIN_BYTES = 65_536;

    private final ReentrantLock reading = new ReentrantLock();
    private final ReentrantLock writing = new ReentrantLock();
    private final String name;
    private final LineSettings line;
    private final SocketChannel channel;
    private final Readiness readable;
    private final Readiness writable;
    private final AtomicBoolean closed = new AtomicBoolean();
    private volatile String loss; // why the far end cannot be reached any more; null while it can

    private TcpTransport(String name, LineSettings line, SocketChannel channel) throws IOException {
        this.name = name;
        this.line = line;
        this.channel = channel;
        readable = new Readiness(channel, SelectionKey.OP_READ);
        writable = new Readiness(channel, SelectionKey.OP_WRITE);
    }

    /** Opens a connection; takes {@value TcpConnector#LIMIT_MILLIS} ms at most, and as long again to look up the host. */
    static TcpTransport connect(String name, TcpAddress address, LineSettings line) throws PortException {
        SocketChannel channel = TcpConnector.connect(name, address);
        try {
            return over(channel, name, line);
        } catch (IOException e) {
            throw new PortFaultException(name, "port " + name + " cannot be opened: " + e.getMessage(), e);
        }
    }

    /** A transport over a connected channel, which becomes its own; closed if this fails. */
    static TcpTransport over(SocketChannel channel, String name, LineSettings line) throws IOException {
        boolean made = false;
        try {
            channel.configureBlocking(false);
            TcpTransport transport = new TcpTransport(name, line, channel);
            made = true;
            return transport;
        } finally {
            if (!made) {
                channel.close();
            }
        }
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
    public boolean mayVanish() {
        return true;
    }

    @Override
    public String doubt() {
        return "does a Javino board listen there?";
    }

    @Override
    public int read(byte[] b, int off, int len, int timeoutMillis) throws PortException {
        long deadline = System.nanoTime() + timeoutMillis * NANOS_PER_MILLI;
        ByteBuffer bytes = ByteBuffer.wrap(b, off, len);
        lock(reading);
        try {
            while (true) {
                int count = move(() -> channel.read(bytes));
                long left = deadline - System.nanoTime();
                if (count > 0 || left <= 0) {
                    return count;
                }
                await(readable, left);
            }
        } finally {
            reading.unlock();
        }
    }

    @Override
    public void write(byte[] b, int off, int len, int timeoutMillis) throws PortException {
        long deadline = System.nanoTime() + timeoutMillis * NANOS_PER_MILLI;
        ByteBuffer bytes = ByteBuffer.wrap(b, off, len);
        if (!taken(writing, deadline)) {
            throw tooLate(bytes, timeoutMillis);
        }
        try {
            while (true) {
                move(() -> channel.write(bytes));
                if (!bytes.hasRemaining()) {
                    return;
                }
                long left = deadline - System.nanoTime();
                if (left <= 0) {
                    throw tooLate(bytes, timeoutMillis);
                }
                await(writable, left);
            }
        } finally {
            writing.unlock();
        }
    }

    private PortTimeoutException tooLate(ByteBuffer bytes, int timeoutMillis) {
        return new PortTimeoutException(name, "port " + name + " took all but " + bytes.remaining() + " bytes of a message within "
                + timeoutMillis + " ms; the far end does not read");
    }

    /** Takes the lock, unless another has it until {@code deadlineNanos}. */
    private boolean taken(ReentrantLock lock, long deadlineNanos) throws PortInterruptedException {
        try {
            return lock.tryLock(Math.max(0, deadlineNanos - System.nanoTime()), TimeUnit.NANOSECONDS);
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(name);
        }
    }

    private void lock(ReentrantLock lock) throws PortInterruptedException {
        try {
            lock.lockInterruptibly();
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(name);
        }
    }

    /** Work with the channel that gives a number of bytes. */
    private interface ChannelWork {
        int run() throws IOException;
    }

    private int move(ChannelWork work) throws PortGoneException {
        requireLine();
        try {
            int count = work.run();
            if (count >= 0) {
                return count;
            }
            loss = "the far end closed the connection";
        } catch (IOException e) {
            if (!closed.get()) {
                loss = "the connection broke (" + e.getMessage() + ")";
            }
        }
        throw noLine();
    }

    private void await(Readiness readiness, long nanos) throws PortException {
        try {
            readiness.await(nanos);
        } catch (IOException e) {
            loss = "the system cannot wait for it (" + e.getMessage() + ")";
            throw noLine();
        }
        requireLine();
        if (Thread.currentThread().isInterrupted()) {
            throw new PortInterruptedException(name);
        }
    }

    private void requireLine() throws PortGoneException {
        if (closed.get() || loss != null) {
            throw noLine();
        }
    }

    private PortGoneException noLine() {
        return new PortGoneException(name, "port " + name + " is gone: " + (loss != null ? loss : "it was closed"));
    }

    @Override
    public void close() {
        if (closed.getAndSet(true)) {
            return;
        }
        try (channel; readable; writable) { // closed from the right: who waits is woken first
            if (loss == null) {
                channel.shutdownOutput();
                drain();
            }
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "port " + name + " was lost while it was closed", e);
        }
    }

    /** A connection that is closed with bytes unread is reset, and the far end may lose what it was sent last. */
    private void drain() throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(DRAIN_BYTES);
        while (bytes.hasRemaining() && channel.read(bytes) > 0) { }
    }
}
