package javino;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** An open port that one owner exchanges messages through. */
public final class Link implements AutoCloseable {
    private final Transport transport;
    private final LinkSettings settings;
    private final Deque<Frame> arrived = new ArrayDeque<>();
    private final FrameDecoder decoder;
    private final byte[] buffer = new byte[1024];
    private volatile boolean open = true;

    private Link(Transport transport, LinkSettings settings) {
        this.transport = transport;
        this.settings = settings;
        decoder = new FrameDecoder(FrameDecoder.interByteTimeoutNanos(settings.line()), arrived::add);
    }

    /** Opens a port for {@code owner}. */
    public static Link open(String port, LinkSettings settings, String owner) throws PortException {
        return new Link(Transports.open(port, settings.line()), settings);
    }

    /** The owner of a port that is open in this program. */
    public static Optional<String> ownerOf(String port) {
        return Optional.empty();
    }

    /** The port's name. */
    public String port() {
        return transport.name();
    }

    /** The settings it was opened with. */
    public LinkSettings settings() {
        return settings;
    }

    /** Whether it is open. */
    public boolean isOpen() {
        return open;
    }

    /** Sends a request and waits for its answer. */
    public String request(String message, int timeoutMillis) throws PortException {
        send(message, timeoutMillis);
        return listen(timeoutMillis);
    }

    /** Sends a message. */
    public void send(String message, int timeoutMillis) throws PortException {
        byte[] bytes = Frame.of(message).toBytes();
        transport.write(bytes, 0, bytes.length, timeoutMillis);
    }

    /** Waits for a message. */
    public String listen(int timeoutMillis) throws PortException {
        long deadline = System.nanoTime() + timeoutMillis * 1_000_000L;
        while (arrived.isEmpty()) {
            long left = deadline - System.nanoTime();
            if (left <= 0) {
                throw new PortTimeoutException(port(), "no message from port " + port() + " within " + timeoutMillis + " ms");
            }
            int count = transport.read(buffer, 0, buffer.length, (int) (left / 1_000_000L) + 1);
            decoder.accept(buffer, 0, count, System.nanoTime());
        }
        return arrived.remove().text();
    }

    @Override
    public void close() {
        open = false;
        transport.close();
    }
}
