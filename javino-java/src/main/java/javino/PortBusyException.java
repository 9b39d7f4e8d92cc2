package javino;

/** The port is open already; {@link #owner()} has it. */
public final class PortBusyException extends PortException {
    private static final long serialVersionUID = 1L;

    private final String owner;

    /**
     * @param owner who has the port, in words: an agent's name, or a process with its id
     */
    public PortBusyException(String port, String owner) {
        super(port, "port " + port + " is in use by " + owner + "; a port has one owner at a time", null);
        this.owner = owner;
    }

    /** Who has the port: the name that its owner in this program gave, or the process that holds it, as far as it can be told. */
    public String owner() {
        return owner;
    }
}
