package javino;

/** An action was given up before its first byte was written; see {@link Link#send(String, int, java.util.function.BooleanSupplier)}. */
final class GivenUpException extends PortException {
    private static final long serialVersionUID = 1L;

    GivenUpException(String port) {
        super(port, "the action for port " + port + " was given up before its turn came", null);
    }
}
