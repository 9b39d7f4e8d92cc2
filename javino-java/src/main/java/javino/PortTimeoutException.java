package javino;

/** Thrown if an operation on the port did not end within its time limit. The port is still open. */
public final class PortTimeoutException extends PortException {
    private static final long serialVersionUID = 1L;

    public PortTimeoutException(String port, String message) {
        super(port, message, null);
    }
}
