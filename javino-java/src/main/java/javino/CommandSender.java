package javino;

/** Takes commands to the board in one version of the protocol: what is specific to the version, behind the queue that is common. */
interface CommandSender {
    /** Milliseconds that a driver may refuse to take a frame. */
    int MAX_WRITE_MILLIS = 5000;

    /**
     * Writes the command whose turn has come, and returns when its outcome is known; that of one that is over already does not matter.
     *
     * @throws ActionRefusedException if the board does not know it, or not with these arguments
     * @throws ActionUnconfirmedException if the board has said neither
     */
    void send(Command command) throws PortException;
}
