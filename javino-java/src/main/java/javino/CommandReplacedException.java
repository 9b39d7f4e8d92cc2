package javino;

/** Before this command began to go out, a later command with the same functor replaced it. No byte of this command is ever sent. */
public final class CommandReplacedException extends PortException {
    private static final long serialVersionUID = 1L;

    public CommandReplacedException(String port, String message) {
        super(port, message, null);
    }
}
