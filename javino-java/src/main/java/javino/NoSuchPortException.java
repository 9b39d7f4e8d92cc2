package javino;

/** There is no port of that name; the message lists the present ports. */
public final class NoSuchPortException extends PortException {
    private static final long serialVersionUID = 1L;

    public NoSuchPortException(String port, String message) {
        super(port, message, null);
    }
}
