package javino.session;

/** The outcome of a command. */
public enum CommandOutcome {
    /** The board has carried it out. */
    DONE,
    /** The board does not know it, takes other arguments, or refuses it now. */
    REFUSED,
    /** The board has begun it, and has reported later that it could not carry it out. */
    FAILED,
    /** The command may or may not have been carried out. */
    UNCONFIRMED,
    /** The command is longer than the board takes, and was not sent. */
    TOO_LONG
}
