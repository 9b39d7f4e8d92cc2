package javino;

/** Thrown if there is no port of the given name. The message lists the present ports. */
public final class NoSuchPortException extends PortException {
    private static final long serialVersionUID = 1L;

    public NoSuchPortException(String port, String message) {
        super(port, message, null);
    }
}
