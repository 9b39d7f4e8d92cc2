package javino;

/** The time limit of a command was over before it began to go out. No byte of it is ever sent. */
public final class CommandWithdrawnException extends PortException {
    private static final long serialVersionUID = 1L;

    public CommandWithdrawnException(String port, String message) {
        super(port, message, null);
    }
}
