package javino;

/** The port is there, but this user may not open it; the message says how to change that. */
public final class PortPermissionException extends PortException {
    private static final long serialVersionUID = 1L;

    public PortPermissionException(String port, String message) {
        super(port, message, null);
    }
}
