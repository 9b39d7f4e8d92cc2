package javino;

/** An operation on the port was not done in the time given. The port is still open. */
public final class PortTimeoutException extends PortException {
    private static final long serialVersionUID = 1L;

    public PortTimeoutException(String port, String message) {
        super(port, message, null);
    }
}
