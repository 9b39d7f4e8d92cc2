package javino.wire;

/** The outcome of the reflex of a rule on a board. */
public enum ReflexOutcome {
    /** The rule has no reflex. */
    NONE,
    /** The board has carried it out. */
    CARRIED_OUT,
    /** The board's program does not know it, or takes other arguments. */
    REFUSED
}
