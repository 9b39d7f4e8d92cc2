package javino;

/** Thrown if a later command with the same functor replaced a queued command. No byte of the replaced command is ever sent. */
public final class CommandReplacedException extends PortException {
    private static final long serialVersionUID = 1L;

    public CommandReplacedException(String port, String message) {
        super(port, message, null);
    }
}
