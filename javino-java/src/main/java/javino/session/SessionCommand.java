package javino.session;

/** A command as a session takes it to the board. */
public interface SessionCommand {
    /** Its text, a character a byte. */
    String text();

    /** Whether its time is over, or nobody waits for its outcome any more: then it is not to be carried out later. */
    boolean isOver();
}
