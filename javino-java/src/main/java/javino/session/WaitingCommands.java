package javino.session;

/** The commands that have not begun to go out. */
public interface WaitingCommands<C> {
    /** The command whose turn is next; null: none waits. */
    C head();

    /** Removes the {@link #head}, which goes out now. */
    void begin();
}
