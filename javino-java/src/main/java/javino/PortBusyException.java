package javino;

/** The port is already open; {@link #owner()} names its owner. */
public final class PortBusyException extends PortException {
    private static final long serialVersionUID = 1L;

    private final String owner;

    /** @param owner the port's owner, in words: an agent's name, or a process with its id */
    public PortBusyException(String port, String owner) {
        super(port, "port " + port + " is in use by " + owner + "; a port has one owner at a time", null);
        this.owner = owner;
    }

    /** The port's owner: its name in this program, or the process that has the port open, if that can be found out. */
    public String owner() {
        return owner;
    }
}
