package javino;

/** The driver refused for a reason that has no exception of its own; the message carries the driver's code. */
public final class PortFaultException extends PortException {
    private static final long serialVersionUID = 1L;

    public PortFaultException(String port, String message, Throwable cause) {
        super(port, message, cause);
    }
}
