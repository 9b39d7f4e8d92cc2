package javino.session;

/** The commands that have not begun to go out. */
public interface WaitingCommands<C> {
    /** Returns the next command, or null if none waits. */
    C head();

    /** Removes the {@link #head}, because it goes out now. */
    void begin();
}
