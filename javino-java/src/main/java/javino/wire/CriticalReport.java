package javino.wire;

/**
 * A board's report that a rule begins to match.
 *
 * @param outcome the outcome of the rule's reflex
 * @param percept the text of the matching percept, with its {@code ;}
 */
public record CriticalReport(int rule, ReflexOutcome outcome, String percept) {
    private static final int HEADER = 2;

    /** Returns the report's bytes, one character a byte. */
    public String payload() {
        return "" + (char) rule + (char) outcome.ordinal() + percept;
    }

    /** Reads a payload. Returns null if it is truncated, or if the outcome of the reflex is unknown. */
    public static CriticalReport read(String payload) {
        ReflexOutcome[] outcomes = ReflexOutcome.values();
        return payload.length() < HEADER || payload.charAt(1) >= outcomes.length
                ? null
                : new CriticalReport(payload.charAt(0), outcomes[payload.charAt(1)], payload.substring(HEADER));
    }
}
