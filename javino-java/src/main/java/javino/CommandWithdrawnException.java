package javino;

/** The time limit of a command ended before the command began to go out. No byte of the command is ever sent. */
public final class CommandWithdrawnException extends PortException {
    private static final long serialVersionUID = 1L;

    public CommandWithdrawnException(String port, String message) {
        super(port, message, null);
    }
}
