package javino;

/** The board knows the action and has tried to carry it out, and has failed. The port is still open. */
public final class ActionFailedException extends PortException {
    private static final long serialVersionUID = 1L;

    public ActionFailedException(String port, String message) {
        super(port, message, null);
    }
}
