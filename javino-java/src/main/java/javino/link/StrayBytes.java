package javino.link;

import java.nio.charset.StandardCharsets;
import javino.LineSettings;

/**
 * The bytes since the last message. Stray bytes form no message. They help a person to find out why a board seems silent.
 *
 * @param count number of the bytes
 * @param first the first of the bytes, at most {@link #MAX_FIRST}, one character a byte
 * @param baud the baud rate at which the bytes were read
 */
public record StrayBytes(long count, String first, int baud) {
    /** The longest {@code first}, in bytes. */
    public static final int MAX_FIRST = 48;

    private static final String HEADER = "fffe";
    private static final int MAX_STRANGE_SHARE = 8;

    /**
     * Returns whether almost all of the bytes are text, such as a sketch's debug output. Bytes that are read at a wrong rate are no text.
     */
    public boolean isText() {
        long strange = first.chars()
                .filter(c -> c > '~' || c < ' ' && "\r\n\t".indexOf(c) < 0)
                .count();
        return strange * MAX_STRANGE_SHARE <= first.length();
    }

    /** Describes the bytes and their likely cause. */
    public String inWords() {
        return count + (count == 1 ? " byte" : " bytes") + " came since the last message and are no message: \""
                + shown() + (count > first.length() ? "\"…, " : "\", ") + cause();
    }

    private String cause() {
        if (!isText()) {
            return baud == LineSettings.NETWORK.baud()
                    ? "which is no text: does a Javino board listen there, or another program?"
                    : "which is no text: does the board run at another rate than " + baud + " baud?";
        }
        if (first.contains(HEADER) || first.matches("f+")) {
            return "a message that is not whole or came with a pause in it: are bytes lost, or is the time for an answer too short?";
        }
        return "which is text without a frame: does the sketch use Serial.print in place of the Javino library?";
    }

    /** Returns the first stray bytes as printable text. Writes a byte outside ASCII as {@code \xHH}. */
    private String shown() {
        StringBuilder text = new StringBuilder();
        for (char c : first.toCharArray()) {
            switch (c) {
                case '\r' -> text.append("\\r");
                case '\n' -> text.append("\\n");
                case '\t' -> text.append("\\t");
                default -> text.append(c >= ' ' && c <= '~' ? String.valueOf(c) : String.format("\\x%02X", (int) c));
            }
        }
        return text.toString();
    }

    static final class Gatherer {
        private final byte[] first = new byte[MAX_FIRST];
        private long count;

        void add(byte[] bytes, int length) {
            if (count < MAX_FIRST) {
                System.arraycopy(bytes, 0, first, (int) count, (int) Math.min(length, MAX_FIRST - count));
            }
            count += length;
        }

        void clear() {
            count = 0;
        }

        StrayBytes soFar(int baud) {
            int length = (int) Math.min(count, MAX_FIRST);
            return new StrayBytes(count, new String(first, 0, length, StandardCharsets.ISO_8859_1), baud);
        }
    }
}
