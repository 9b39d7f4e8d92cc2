package javino;

import java.io.IOException;

/** A failure of one port. The subclass is the kind of failure. The message says what failed, and what to do. */
public abstract class PortException extends IOException {
    private static final long serialVersionUID = 1L;

    private final String port;

    PortException(String port, String message, Throwable cause) {
        super(message, cause);
        this.port = port;
    }

    /** Returns the port's name as the caller gave it. */
    public String port() {
        return port;
    }
}
