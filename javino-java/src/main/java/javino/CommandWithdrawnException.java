package javino;

/** A command had not begun to go out when its time was over; none of it was sent, and none will be. */
public final class CommandWithdrawnException extends PortException {
    private static final long serialVersionUID = 1L;

    public CommandWithdrawnException(String port, String message) {
        super(port, message, null);
    }
}
