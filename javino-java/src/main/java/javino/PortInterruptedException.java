package javino;

/**
 * Thrown if the calling thread was interrupted while it waited for the port. The thread stays marked as interrupted. The port is still
 * open.
 */
public final class PortInterruptedException extends PortException {
    private static final long serialVersionUID = 1L;

    public PortInterruptedException(String port) {
        super(port, "interrupted while waiting for port " + port, null);
    }

    /** Marks the calling thread as interrupted again. Returns the exception to throw in place of an {@link InterruptedException}. */
    public static PortInterruptedException remarking(String port) {
        Thread.currentThread().interrupt();
        return new PortInterruptedException(port);
    }
}
