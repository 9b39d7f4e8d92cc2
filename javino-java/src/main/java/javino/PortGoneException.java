package javino;

/** The port was open and is not any more: its device was unplugged, the far end closed, or this program closed it. */
public final class PortGoneException extends PortException {
    private static final long serialVersionUID = 1L;

    public PortGoneException(String port, String message) {
        super(port, message, null);
    }
}
