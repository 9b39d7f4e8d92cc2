package javino;

/** Thrown if the port exists, but this user may not open it. The message says how to get the permission. */
public final class PortPermissionException extends PortException {
    private static final long serialVersionUID = 1L;

    public PortPermissionException(String port, String message) {
        super(port, message, null);
    }
}
