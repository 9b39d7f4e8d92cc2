package javino;

import java.io.IOException;

/** Something that went wrong with one port. The subclass says what, the message says it to a person, with what to do. */
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
