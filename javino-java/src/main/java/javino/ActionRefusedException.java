package javino;

/** The board has refused the action: it does not know it, takes other arguments, or refuses it now. It has not acted. The port is open. */
public final class ActionRefusedException extends PortException {
    private static final long serialVersionUID = 1L;

    public ActionRefusedException(String port, String message) {
        super(port, message, null);
    }
}
