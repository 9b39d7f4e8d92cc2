package javino.session;

import javino.wire.CommandItem;

/** A command that a session sends to the board. */
public interface SessionCommand {
    /** Returns the command's text, one character a byte. For a change of rules, returns a description for a person. */
    String text();

    /** Returns the command's change of the board's rules. Returns null for a text command. */
    default CommandItem.Rule rule() {
        return null;
    }

    /** Returns whether the command's time is over or nobody waits for its outcome. The board must not carry out a command that is over. */
    boolean isOver();
}
