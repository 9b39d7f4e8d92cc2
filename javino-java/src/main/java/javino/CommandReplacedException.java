package javino;

/** A command had not begun to go out when a later one of the same functor took its place; none of it was sent, and none will be. */
public final class CommandReplacedException extends PortException {
    private static final long serialVersionUID = 1L;

    public CommandReplacedException(String port, String message) {
        super(port, message, null);
    }
}
