package javino.session;

import javino.wire.CommandItem;

/** A command as a session takes it to the board. */
public interface SessionCommand {
    /** Its text, a character a byte; of one that changes rules what a person is told of it. */
    String text();

    /** What it does to the rules of the board; null: nothing, the text is for the board's program. */
    default CommandItem.Rule rule() {
        return null;
    }

    /** Whether its time is over, or nobody waits for its outcome any more: then it is not to be carried out later. */
    boolean isOver();
}
