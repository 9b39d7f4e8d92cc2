package javino.link;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.locks.ReentrantLock;
import javino.PortException;
import javino.Protocol;
import javino.Transports;

/**
 * The classic interface of Javino: one call for each operation on a port. Each call returns whether it succeeded.
 *
 * <p>The first call that names a port opens the port. The port stays open until {@link #close()}, because opening resets most boards. If
 * the port's device has gone, the next call opens the port again. No call throws an exception of the line. {@link #lastError()} says why
 * a call returned false.
 *
 * <p>By default Javino speaks version 1 of the protocol, for older programs. Settings can ask for version 2.
 *
 * <p>Any thread may call. {@link #getData()} and {@link #lastError()} are about the latest call of all threads. Not final, so tests can
 * use a subclass.
 */
public class Javino implements AutoCloseable {
    private static final int DEFAULT_TIMEOUT_MILLIS = 1_000;

    private final ReentrantLock opening = new ReentrantLock();
    private final Map<String, Link> links = new HashMap<>(); // key: the port's canonical name; guarded by opening
    private final LinkSettings settings;
    private final boolean usualRate;
    private final int timeoutMillis;
    private volatile String data = "";
    private volatile String lastError = "";

    /** Uses {@link LinkSettings#defaults()}, the {@linkplain Transports#usualLine usual rate} of each port, and time limits of 1000 ms. */
    public Javino() {
        this(LinkSettings.defaults(), DEFAULT_TIMEOUT_MILLIS, true);
    }

    /**
     * @param settings the settings for every port. {@link Protocol#AUTO} means version 1 here
     * @param timeoutMillis milliseconds that a call waits for the line and for a message, at least 1
     */
    public Javino(LinkSettings settings, int timeoutMillis) {
        this(settings, timeoutMillis, false);
    }

    private Javino(LinkSettings settings, int timeoutMillis, boolean usualRate) {
        this.usualRate = usualRate;
        this.settings = settings.protocol() == Protocol.AUTO ? settings.withProtocol(Protocol.V1) : settings;
        this.timeoutMillis = timeoutMillis;
    }

    /**
     * Sends an action: {@code sendCommand("ttyACM0", "ledOn")}. Returns true when the command has left (version 1) or the board has acted
     * (version 2).
     */
    public boolean sendCommand(String port, String msg) {
        return succeeds(() -> link(port).sendAndAwait(msg, timeoutMillis));
    }

    /** Sends a request, such as {@code getPercepts}. Returns true when the answer is in {@link #getData()}. */
    public boolean requestData(String port, String msg) {
        return succeeds(() -> data = link(port).request(msg, timeoutMillis).text());
    }

    /** Waits for a message that the board sends on its own. Returns true when the message is in {@link #getData()}. */
    public boolean listenHardware(String port) {
        return succeeds(() -> data = link(port).listen(timeoutMillis).text());
    }

    /** Returns the last message that a call received. Empty if no call has received a message. */
    public String getData() {
        return data;
    }

    /** Returns why the latest failed call returned false. Empty if no call has failed. */
    public String lastError() {
        return lastError;
    }

    /** Closes all open ports. A later call opens its port again. */
    @Override
    public void close() {
        opening.lock();
        try {
            links.values().forEach(Link::close);
            links.clear();
        } finally {
            opening.unlock();
        }
    }

    private Link link(String port) throws PortException {
        String name = Transports.canonicalName(port);
        opening.lock();
        try {
            links.values().removeIf(other -> !other.isOpen());
            Link link = links.get(name);
            if (link == null) {
                link = Link.open(
                        port,
                        usualRate ? settings.withBaud(Transports.usualLine(port).baud()) : settings,
                        "Javino");
                links.put(name, link);
            }
            return link;
        } finally {
            opening.unlock();
        }
    }

    private boolean succeeds(LineWork work) {
        try {
            work.run();
            return true;
        } catch (PortException
                | IllegalArgumentException e) { // IllegalArgumentException: the message fits into no frame
            lastError = e.getMessage();
            return false;
        }
    }

    private interface LineWork {
        void run() throws PortException;
    }
}
