package javino;

import java.io.IOException;

/** A failure of one port. The subclass tells the kind of failure; the message says what failed, and what to do. */
public abstract class PortException extends IOException {
    private static final long serialVersionUID = 1L;

    private final String port;

    PortException(String port, String message, Throwable cause) {
        super(message, cause);
        this.port = port;
    }

    /** The port's name as it was given. */
    public String port() {
        return port;
    }
}
