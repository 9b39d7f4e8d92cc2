package javino;

/** Thrown if the driver refused for a reason that has no exception class. The message contains the driver's error code. */
public final class PortFaultException extends PortException {
    private static final long serialVersionUID = 1L;

    public PortFaultException(String port, String message, Throwable cause) {
        super(port, message, cause);
    }
}
