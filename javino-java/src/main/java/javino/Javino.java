package javino;

import java.util.HashMap;
import java.util.Map;

/** The interface that Javino programs know. */
public class Javino {
    private static final int TIMEOUT_MILLIS = 1_000;

    private final Map<String, Link> links = new HashMap<>();
    private String data = "";
    private String lastError = "";

    /** Sends a message. */
    public boolean sendCommand(String port, String msg) {
        return succeeds(() -> link(port).send(msg, TIMEOUT_MILLIS));
    }

    /** Sends a request and waits for its answer. */
    public boolean requestData(String port, String msg) {
        return succeeds(() -> data = link(port).request(msg, TIMEOUT_MILLIS));
    }

    /** Waits for a message. */
    public boolean listenHardware(String port) {
        return succeeds(() -> data = link(port).listen(TIMEOUT_MILLIS));
    }

    /** The last message. */
    public String getData() {
        return data;
    }

    /** Why the last call returned false. */
    public String lastError() {
        return lastError;
    }

    /** Closes all ports. */
    public void close() {
        links.values().forEach(Link::close);
        links.clear();
    }

    private Link link(String port) throws PortException {
        Link link = links.get(port);
        if (link == null) {
            link = Link.open(port, LinkSettings.defaults(), "Javino");
            links.put(port, link);
        }
        return link;
    }

    private boolean succeeds(LineWork work) {
        try {
            work.run();
            return true;
        } catch (PortException e) {
            lastError = e.getMessage();
            return false;
        }
    }

    private interface LineWork {
        void run() throws PortException;
    }
}
