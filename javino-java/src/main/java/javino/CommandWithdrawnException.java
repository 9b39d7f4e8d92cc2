package javino;

/** Thrown if a command's time limit ended before the command's first byte was sent. No byte of the command is ever sent. */
public final class CommandWithdrawnException extends PortException {
    private static final long serialVersionUID = 1L;

    public CommandWithdrawnException(String port, String message) {
        super(port, message, null);
    }
}
