package javino;

/** A later command of the same functor took the place of this one before it began to go out. No byte of it is ever sent. */
public final class CommandReplacedException extends PortException {
    private static final long serialVersionUID = 1L;

    public CommandReplacedException(String port, String message) {
        super(port, message, null);
    }
}
