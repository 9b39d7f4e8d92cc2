package javino;

/** Thrown if the board began an action and failed to complete it. The port is still open. */
public final class ActionFailedException extends PortException {
    private static final long serialVersionUID = 1L;

    public ActionFailedException(String port, String message) {
        super(port, message, null);
    }
}
