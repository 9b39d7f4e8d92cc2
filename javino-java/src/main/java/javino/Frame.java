package javino;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A message of version 1 of the Javino protocol: {@code fffe}, the payload's length in two hexadecimal digits, and the payload. The
 * payload has 0 to {@value #MAX_PAYLOAD} bytes. Each character of the text is one byte (ISO-8859-1). Immutable and safe on any thread.
 * {@link javino.wire.WireFrame} is the frame of version 2.
 *
 * @param text the payload as text, one character a byte (ISO-8859-1)
 */
public record Frame(String text) {
    /** The length of the longest payload, in bytes. */
    public static final int MAX_PAYLOAD = 255;

    /** Length of the header in bytes: four of preamble, two of length. */
    public static final int HEADER_LENGTH = 6;

    private static final char DELETE = 0x7F;
    private static final String PREAMBLE = "fffe";
    private static final char[] DIGITS = "0123456789ABCDEF".toCharArray();

    private static final Pattern HEADER = Pattern.compile(PREAMBLE + "\\p{XDigit}{2}");

    /** @throws IllegalArgumentException if the text has more than {@value #MAX_PAYLOAD} characters, or a character above U+00FF */
    public Frame {
        requireBytes(text);
        if (text.length() > MAX_PAYLOAD) {
            throw new IllegalArgumentException(
                    "a message has at most " + MAX_PAYLOAD + " bytes, but " + quoted(text) + " has " + text.length());
        }
    }

    /** Returns a frame with the payload {@code text}; see {@link #Frame}. */
    public static Frame of(String text) {
        return new Frame(text);
    }

    /**
     * Like {@link #of(String)}, for a command. The text must not contain the header of a frame, because a board searches a damaged frame
     * for other frames.
     *
     * @throws IllegalArgumentException also if the text contains {@code fffe} and two hexadecimal digits, or a control character (U+0000
     *     to U+001F, U+007F)
     */
    public static Frame ofCommand(String text) {
        for (int i = 0; i < text.length(); i++) {
            if (text.charAt(i) < ' ' || text.charAt(i) == DELETE) {
                throw new IllegalArgumentException(String.format(
                        Locale.ROOT,
                        "the command %s holds the control character U+%04X as character %d, and commands have none; leave it out",
                        quoted(text.replaceAll("\\p{Cntrl}", "?")),
                        (int) text.charAt(i),
                        i + 1));
            }
        }
        if (text.contains(PREAMBLE)) { // faster than the pattern, which most commands do not need
            requireNoHeader(text);
        }
        return of(text);
    }

    private static void requireNoHeader(String text) {
        Matcher header = HEADER.matcher(text);
        if (header.find()) {
            throw new IllegalArgumentException(
                    "the command " + quoted(text) + " holds " + quoted(header.group()) + " from character "
                            + (header.start() + 1)
                            + " on, which a board may take for the beginning of another command; leave it out, "
                            + "or put a character in between");
        }
    }

    /**
     * Returns a frame with a copy of {@code payload}.
     *
     * @throws IllegalArgumentException if the payload has more than {@value #MAX_PAYLOAD} bytes
     */
    public static Frame of(byte[] payload) {
        return new Frame(new String(payload, StandardCharsets.ISO_8859_1));
    }

    static Frame copyOf(byte[] source, int offset, int length) {
        return new Frame(new String(source, offset, length, StandardCharsets.ISO_8859_1));
    }

    /**
     * Returns {@code text} unchanged.
     *
     * @throws IllegalArgumentException if the text has a character above U+00FF
     */
    public static String requireBytes(String text) {
        for (int i = 0; i < text.length(); i++) {
            if (text.charAt(i) > 0xFF) {
                throw new IllegalArgumentException(String.format(
                        Locale.ROOT,
                        "a message carries one byte per character, but character %d of %s is U+%04X; the highest is U+00FF",
                        i + 1,
                        quoted(text),
                        (int) text.charAt(i)));
            }
        }
        return text;
    }

    /** Returns {@code text} in quotes, for a message to a person. Shortens a text of more than 40 characters. */
    public static String quoted(String text) {
        return text.length() <= 40 ? '"' + text + '"' : '"' + text.substring(0, 40) + "...\"";
    }

    /** Returns a copy of the payload's bytes. */
    public byte[] payload() {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    /** Returns the number of bytes of this frame: {@value #HEADER_LENGTH} for the header, and the payload. */
    public int length() {
        return HEADER_LENGTH + text.length();
    }

    /** Returns the frame's bytes in a new array. The digits of the length are in upper case. */
    public byte[] toBytes() {
        byte[] bytes = new byte[length()];
        copy(PREAMBLE, bytes, 0);
        bytes[HEADER_LENGTH - 2] = (byte) DIGITS[text.length() >> 4];
        bytes[HEADER_LENGTH - 1] = (byte) DIGITS[text.length() & 0xF];
        copy(text, bytes, HEADER_LENGTH);
        return bytes;
    }

    private static void copy(String text, byte[] bytes, int at) {
        System.arraycopy(text.getBytes(StandardCharsets.ISO_8859_1), 0, bytes, at, text.length());
    }

    /** Returns the whole frame as text, for logs and test reports. */
    @Override
    public String toString() {
        return new String(toBytes(), StandardCharsets.ISO_8859_1);
    }
}
