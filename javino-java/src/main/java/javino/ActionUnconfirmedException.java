package javino;

/**
 * Thrown if the board has not confirmed an action that was sent repeatedly. The board may have acted, because its acknowledgements may
 * have been lost. The port is still open.
 */
public final class ActionUnconfirmedException extends PortException {
    private static final long serialVersionUID = 1L;

    public ActionUnconfirmedException(String port, String message) {
        super(port, message, null);
    }
}
