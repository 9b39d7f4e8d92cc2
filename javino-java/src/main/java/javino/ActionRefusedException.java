package javino;

/**
 * Thrown if the board has not acted: it does not know the action, takes other arguments, or refuses the action now. The port is still
 * open.
 */
public final class ActionRefusedException extends PortException {
    private static final long serialVersionUID = 1L;

    public ActionRefusedException(String port, String message) {
        super(port, message, null);
    }
}
