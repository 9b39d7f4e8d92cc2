package javino.session;

/** The outcome of a command. */
public enum CommandOutcome {
    /** The board has carried the command out. */
    DONE,
    /** The board does not know the command, takes other arguments, or refuses it now. */
    REFUSED,
    /** The board has begun the command, and has reported a failure later. */
    FAILED,
    /** The board may or may not have carried the command out. */
    UNCONFIRMED,
    /** The command was not sent, because it is longer than the board can take. */
    TOO_LONG
}
