package javino.wire;

/**
 * What a board says of itself when a session begins.
 *
 * @param nonce the session's; 0: the board has no session
 * @param credit bytes of frames that it can hold while its program is busy
 * @param longestPayload bytes of payload that it takes
 * @param rules how many critical rules it holds at most
 */
public record Welcome(int nonce, int credit, int longestPayload, int rules) {
    /** Bytes of its payload. */
    private static final int LENGTH = 4;

    /** What a board without a session says. */
    public static final Welcome NO_SESSION = new Welcome(0, 0, 0, 0);

    /** Its bytes. */
    public String payload() {
        return "" + (char) nonce + (char) credit + (char) longestPayload + (char) rules;
    }

    /** Reads a payload; null: it is cut. */
    public static Welcome read(String payload) {
        return payload.length() < LENGTH
                ? null
                : new Welcome(payload.charAt(0), payload.charAt(1), payload.charAt(2), payload.charAt(3));
    }
}
