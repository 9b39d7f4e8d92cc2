package javino.wire;

/** The outcome of the reflex of a rule on a board. */
public enum ReflexOutcome {
    /** The rule has no reflex. */
    NONE,
    /** The board has carried the reflex out. */
    CARRIED_OUT,
    /** The board's program does not know the reflex, or takes other arguments. */
    REFUSED
}
