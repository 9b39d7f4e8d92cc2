package javino;

/**
 * The action was sent, and sent again, but the board has not confirmed that it acted. The board may have acted: the acknowledgements may
 * have been lost. The port is still open.
 */
public final class ActionUnconfirmedException extends PortException {
    private static final long serialVersionUID = 1L;

    public ActionUnconfirmedException(String port, String message) {
        super(port, message, null);
    }
}
