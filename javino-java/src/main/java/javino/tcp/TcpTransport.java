package javino.tcp;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.concurrent.TimeUnit;
import javino.DriverTransport;
import javino.LineSettings;
import javino.PortGoneException;

/** A TCP connection to a board on the network, or to a serial server with a board behind it. */
class TcpTransport extends DriverTransport {
    private static final System.Logger LOG = System.getLogger(TcpTransport.class.getName());
    /** The longest wait of one read of the socket. An interrupt does not end a read. */
    private static final int MAX_SLICE_MILLIS = 100;

    private static final int DRAIN_BYTES = 65_536;

    private final Socket socket;
    private final InputStream in;

    TcpTransport(Socket socket, String name, LineSettings line) throws IOException {
        this(socket, socket.getInputStream(), name, line);
    }

    /** Like the other constructor, but reads from {@code in}. */
    TcpTransport(Socket socket, InputStream in, String name, LineSettings line) {
        super(name, line);
        this.socket = socket;
        this.in = in;
    }

    /** Returns whether {@link InputStream#available} counts all arrived bytes. */
    boolean isInputPlain() {
        return true;
    }

    @Override
    public boolean mayVanish() {
        return true;
    }

    @Override
    public String doubt() {
        return "does a Javino board listen there? One that answers later needs a longer timeout";
    }

    @Override
    protected int readFromDriver(byte[] b, int off, int len, long nanos) throws PortGoneException {
        try {
            if (nanos <= 0 && isInputPlain() && in.available() == 0) {
                return 0;
            }
            socket.setSoTimeout(
                    (int) Math.min(MAX_SLICE_MILLIS, 1 + TimeUnit.NANOSECONDS.toMillis(Math.max(0, nanos))));
            int count = in.read(b, off, len);
            if (count >= 0) {
                return count;
            }
        } catch (SocketTimeoutException e) {
            return 0;
        } catch (IOException e) {
            throw lost(broken(e));
        }
        throw lost("the far end closed the connection");
    }

    @Override
    protected int writeToDriver(byte[] bytes) {
        try {
            socket.getOutputStream().write(bytes);
            return bytes.length;
        } catch (IOException e) {
            lost(broken(e));
            return -1;
        }
    }

    @Override
    protected String lossWhenRefused() {
        return "the connection broke"; // shown only if no better reason is known
    }

    String broken(IOException e) {
        return "the connection broke (" + e.getMessage() + ")";
    }

    @Override
    protected void closeDriver() {
        try (socket) {
            if (!isLost()) {
                socket.shutdownOutput();
                drain(socket, in);
            }
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "port " + name() + " was lost while this closed it", e);
        }
    }

    /** Reads the unread bytes. With unread bytes a close becomes a reset, and the far end may lose the last bytes sent to it. */
    static void drain(Socket socket, InputStream in) throws IOException {
        socket.setSoTimeout(1);
        int drained = 0;
        while (drained < DRAIN_BYTES && in.available() > 0) {
            drained += in.readNBytes(in.available()).length;
        }
    }
}
