package javino.wire;

/**
 * A board's description of itself when a session begins.
 *
 * @param nonce the nonce of the session; 0: the board has no session
 * @param credit bytes of frames that the board can hold while its program is busy
 * @param longestPayload length of the longest payload that the board takes
 * @param rules number of critical rules that the board can hold
 * @param revision the revision of version 2 that the board speaks; 0: a revision before {@link #REVISION}
 * @param actionsLost number of the program's actions that the board has no room for
 */
public record Welcome(int nonce, int credit, int longestPayload, int rules, int revision, int actionsLost) {
    /** The revision of version 2 that this library speaks. */
    public static final int REVISION = 1;

    /** The payload of a board that has no session. */
    public static final Welcome NO_SESSION = new Welcome(0, 0, 0, 0);

    private static final int LEAST_LENGTH = 4;

    /** Creates the description of a board with the present revision and room for all its actions. */
    public Welcome(int nonce, int credit, int longestPayload, int rules) {
        this(nonce, credit, longestPayload, rules, REVISION, 0);
    }

    /** Returns the payload's bytes, one character a byte. */
    public String payload() {
        return "" + (char) nonce + (char) credit + (char) longestPayload + (char) rules + (char) revision
                + (char) actionsLost;
    }

    /** Reads a payload. Returns null if it is truncated. */
    public static Welcome read(String payload) {
        return payload.length() < LEAST_LENGTH
                ? null
                : new Welcome(
                        payload.charAt(0),
                        payload.charAt(1),
                        payload.charAt(2),
                        payload.charAt(3),
                        octetAt(payload, LEAST_LENGTH),
                        octetAt(payload, LEAST_LENGTH + 1));
    }

    private static int octetAt(String payload, int place) {
        return place < payload.length() ? payload.charAt(place) : 0;
    }
}
