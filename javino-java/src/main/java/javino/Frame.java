package javino;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * One message of version 1 of the Javino protocol: {@code fffe}, the payload's length in two hexadecimal digits, the payload.
 *
 * <p>A payload is 0 to {@value #MAX_PAYLOAD} bytes. As text it is read as ISO-8859-1, one byte a character, whatever the
 * platform's charset is, so that bytes outside ASCII are carried untouched. Immutable, hence safe on any thread.
 */
public final class Frame {
    /** The longest payload, in bytes: the length field has two hexadecimal digits. */
    public static final int MAX_PAYLOAD = 255;

    /** Bytes on the line before the payload: four of preamble, two of length. */
    public static final int HEADER_LENGTH = 6;

    private static final byte[] PREAMBLE = {'f', 'f', 'f', 'e'};
    private static final char[] DIGITS = "0123456789ABCDEF".toCharArray();

    private final byte[] payload;

    private Frame(byte[] payload) {
        this.payload = payload;
    }

    /**
     * The frame that carries {@code text}.
     *
     * @throws IllegalArgumentException if the text has more than {@value #MAX_PAYLOAD} characters, or one above U+00FF,
     *     which does not fit into a byte
     */
    public static Frame of(String text) {
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c > 0xFF) {
                throw new IllegalArgumentException(String.format(
                        "a message carries one byte per character, but character %d of %s is U+%04X; the highest is U+00FF",
                        i + 1, quoted(text), (int) c));
            }
        }
        checkLength(text.length(), text);
        return new Frame(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    /**
     * The frame that carries a copy of {@code payload}.
     *
     * @throws IllegalArgumentException if the payload has more than {@value #MAX_PAYLOAD} bytes
     */
    public static Frame of(byte[] payload) {
        checkLength(payload.length, new String(payload, StandardCharsets.ISO_8859_1));
        return new Frame(payload.clone());
    }

    /** The frame that carries a copy of {@code length} bytes of {@code source}; the caller has checked the length. */
    static Frame copyOf(byte[] source, int offset, int length) {
        return new Frame(Arrays.copyOfRange(source, offset, offset + length));
    }

    private static void checkLength(int length, String text) {
        if (length > MAX_PAYLOAD) {
            throw new IllegalArgumentException(String.format(
                    "a message has at most %d bytes, but %s has %d", MAX_PAYLOAD, quoted(text), length));
        }
    }

    private static String quoted(String text) {
        return text.length() <= 40 ? '"' + text + '"' : '"' + text.substring(0, 40) + "...\"";
    }

    /** A copy of the payload's bytes. */
    public byte[] payload() {
        return payload.clone();
    }

    /** The payload as text, one character a byte (ISO-8859-1). */
    public String text() {
        return new String(payload, StandardCharsets.ISO_8859_1);
    }

    /** Bytes this frame takes on the line: its payload and {@value #HEADER_LENGTH} of header. */
    public int length() {
        return HEADER_LENGTH + payload.length;
    }

    /** The bytes for the line, in an array of the caller's own; the length is written in upper-case digits. */
    public byte[] toBytes() {
        byte[] bytes = Arrays.copyOf(PREAMBLE, length());
        bytes[4] = (byte) DIGITS[payload.length >> 4];
        bytes[5] = (byte) DIGITS[payload.length & 0xF];
        System.arraycopy(payload, 0, bytes, HEADER_LENGTH, payload.length);
        return bytes;
    }

    /** Whether {@code other} is a frame with the same payload. */
    @Override
    public boolean equals(Object other) {
        return other instanceof Frame frame && Arrays.equals(payload, frame.payload);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(payload);
    }

    /** The frame as it is on the line, for logs and test reports. */
    @Override
    public String toString() {
        return new String(toBytes(), StandardCharsets.ISO_8859_1);
    }
}
