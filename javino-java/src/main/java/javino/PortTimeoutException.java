package javino;

/** What was asked of the port did not happen in the time given. The port is still open. */
public final class PortTimeoutException extends PortException {
    private static final long serialVersionUID = 1L;

    public PortTimeoutException(String port, String message) {
        super(port, message, null);
    }
}
