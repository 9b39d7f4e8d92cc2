package javino.tcp;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import javino.LineClock;
import javino.LineSettings;
import javino.PortException;
import javino.PortFaultException;
import javino.PortGoneException;
import javino.PortInterruptedException;
import javino.PortTimeoutException;
import javino.TimedWriter;
import javino.Transport;

/** A TCP connection to a board on the network, or to a serial server with a board behind it. */
final class TcpTransport implements Transport {
    private static final System.Logger LOG = System.getLogger(TcpTransport.class.getName());
    /** How long one read of the socket waits, which no interrupt ends. */
    private static final int MAX_SLICE_MILLIS = 100;
    private static final int DRAIN_BYTES = 65_536;

    private final String name;
    private final LineSettings line;
    private final Socket socket;
    private final InputStream in;
    private final OutputStream out;
    private final TimedWriter writer;
    private final AtomicBoolean closed = new AtomicBoolean();
    private volatile String loss; // why the far end cannot be reached any more; null while it can

    private TcpTransport(Socket socket, String name, LineSettings line) throws IOException {
        this.name = name;
        this.line = line;
        this.socket = socket;
        in = socket.getInputStream();
        out = socket.getOutputStream();
        writer = new TimedWriter(name, this::writeAll, LineClock.system());
    }

    /** Opens a connection; takes {@value TcpConnector#LIMIT_MILLIS} ms at most, and as long again to look up the host. */
    static TcpTransport connect(String name, TcpAddress address, LineSettings line) throws PortException {
        Socket socket = TcpConnector.connect(name, address);
        try {
            return over(socket, name, line);
        } catch (IOException e) {
            throw new PortFaultException(name, "port " + name + " cannot be opened: " + e.getMessage(), e);
        }
    }

    /** A transport over a connected socket, which becomes its own. */
    static TcpTransport over(Socket socket, String name, LineSettings line) throws IOException {
        TcpTransport transport = new TcpTransport(socket, name, line);
        transport.writer.start();
        return transport;
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
        long deadline = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        while (true) {
            requireLine();
            long left = deadline - System.nanoTime();
            int count = readFor(b, off, len, left);
            if (count > 0 || left <= 0) {
                return count;
            }
            if (Thread.currentThread().isInterrupted()) {
                throw new PortInterruptedException(name);
            }
        }
    }

    /** Reads what has arrived, waiting for it a slice at most, and not at all if there is no time left. */
    private int readFor(byte[] b, int off, int len, long nanos) throws PortGoneException {
        try {
            if (nanos <= 0 && in.available() == 0) {
                return 0;
            }
            socket.setSoTimeout((int) Math.min(MAX_SLICE_MILLIS, 1 + TimeUnit.NANOSECONDS.toMillis(Math.max(0, nanos))));
            int count = in.read(b, off, len);
            if (count >= 0) {
                return count;
            }
            loss = "the far end closed the connection";
        } catch (SocketTimeoutException e) {
            return 0;
        } catch (IOException e) {
            lost(e);
        }
        throw noLine();
    }

    @Override
    public void write(byte[] b, int off, int len, int timeoutMillis) throws PortException {
        requireLine();
        long deadline = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        try {
            switch (writer.write(b, off, len, deadline)) {
                case WRITTEN -> { }
                case TOO_LATE -> throw new PortTimeoutException(name, "port " + name + " did not take " + len + " bytes within "
                        + timeoutMillis + " ms; the far end does not read");
                default -> throw noLine();
            }
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(name);
        }
    }

    private int writeAll(byte[] bytes) {
        try {
            out.write(bytes);
            return bytes.length;
        } catch (IOException e) {
            lost(e);
            return -1;
        }
    }

    private void lost(IOException e) {
        if (!closed.get() && loss == null) {
            loss = "the connection broke (" + e.getMessage() + ")";
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
        writer.close();
        try (socket) {
            if (loss == null) {
                socket.shutdownOutput();
                drain();
            }
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "port " + name + " was lost while it was closed", e);
        }
    }

    /** A connection that is closed with bytes unread is reset, and the far end may lose what it was sent last. */
    private void drain() throws IOException {
        socket.setSoTimeout(1);
        int drained = 0;
        while (drained < DRAIN_BYTES && in.available() > 0) {
            drained += in.readNBytes(in.available()).length;
        }
    }
}
