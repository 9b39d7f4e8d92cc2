package javino.session;

import javino.wire.CommandItem;

/** A command that a session sends to the board. */
public interface SessionCommand {
    /** The command's text, a character a byte; for a command that changes rules, a description for a person. */
    String text();

    /** The command's change of the board's rules; null: the text is for the board's program. */
    default CommandItem.Rule rule() {
        return null;
    }

    /** Returns whether the command's time is over or nobody waits for its outcome. The board must not carry out such a command. */
    boolean isOver();
}
