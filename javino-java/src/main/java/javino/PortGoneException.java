package javino;

/** Thrown if an open port was lost or closed: its device was unplugged, the far end closed, or this program closed the port. */
public final class PortGoneException extends PortException {
    private static final long serialVersionUID = 1L;

    public PortGoneException(String port, String message) {
        super(port, message, null);
    }
}
