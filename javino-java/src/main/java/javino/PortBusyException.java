package javino;

/** Thrown if the port is already open. */
public final class PortBusyException extends PortException {
    private static final long serialVersionUID = 1L;

    private final String owner;

    /** @param owner the port's owner for a message, such as an agent's name, or a process with its id */
    public PortBusyException(String port, String owner) {
        super(port, "port " + port + " is in use by " + owner + "; a port has one owner at a time", null);
        this.owner = owner;
    }

    /** Returns the port's owner: its name in this program, or the process that has the port open. The owner may be unknown. */
    public String owner() {
        return owner;
    }
}
