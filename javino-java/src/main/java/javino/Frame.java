package javino;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What travels as a unit: of version 1 of the Javino protocol {@code fffe}, the payload's length in two hexadecimal digits, the payload; of
 * version 2 {@code fffd}, the length, a digit of flags, a digit that counts the sender's frames, the payload, and four digits of
 * CRC-16/CCITT-FALSE over all of that but the preamble. In version 1 a frame is a message; in version 2 it may be a part of one.
 *
 * <p>A payload is 0 to {@value #MAX_PAYLOAD} bytes. As text it is read as ISO-8859-1, one byte a character, whatever the
 * platform's charset is, so that bytes outside ASCII are carried untouched. Immutable, hence safe on any thread.
 */
public final class Frame {
    /** The longest payload, in bytes: the length field has two hexadecimal digits. */
    public static final int MAX_PAYLOAD = 255;

    /** Bytes on the line that begin a frame of either version, and all before the payload in version 1: four of preamble, two of length. */
    public static final int HEADER_LENGTH = 6;

    /** Flag of version 2: more fragments of the same message follow. */
    public static final int MORE = 1;

    /** Flag of version 2: the sender repeats this frame until it is acknowledged or refused. */
    public static final int ACK_WANTED = 2;

    /** Flag of version 2: the action with this sequence number has been carried out. */
    public static final int ACK = 4;

    /** Flag of version 2: the action with this sequence number is unknown or malformed. */
    public static final int REFUSAL = 8;

    /** Bytes before the payload in version 2. */
    static final int HEADER_LENGTH_2 = HEADER_LENGTH + 2;

    /** Bytes behind the payload in version 2. */
    static final int CRC_LENGTH = 4;

    /** Bytes that a frame of version 2 is longer than one of version 1. */
    static final int VERSION_2_OVERHEAD = HEADER_LENGTH_2 - HEADER_LENGTH + CRC_LENGTH;

    /** Sequence numbers count modulo this. */
    public static final int SEQUENCES = 16;

    private static final int PREAMBLE_LENGTH = 4;
    private static final char[] DIGITS = "0123456789ABCDEF".toCharArray();

    private static final Pattern HEADER = Pattern.compile("fff[ed]\\p{XDigit}{2}");

    private final int version;
    private final int flags;
    private final int sequence;
    private final String text; // a byte a character

    private Frame(int version, int flags, int sequence, String text) {
        if (text.length() > MAX_PAYLOAD) {
            throw new IllegalArgumentException(
                    "a message has at most " + MAX_PAYLOAD + " bytes, but " + quoted(text) + " has " + text.length());
        }
        this.version = version;
        this.flags = digit("flags", flags);
        this.sequence = digit("a sequence number", sequence);
        this.text = text;
    }

    private static int digit(String what, int value) {
        if (value < 0 || value >= SEQUENCES) {
            throw new IllegalArgumentException(
                    what + " of a frame is 0 to " + (SEQUENCES - 1) + ", but " + value + " was given");
        }
        return value;
    }

    /**
     * The version 1 frame that carries {@code text}.
     *
     * @throws IllegalArgumentException if the text has more than {@value #MAX_PAYLOAD} characters, or one above U+00FF,
     *     which does not fit into a byte
     */
    public static Frame of(String text) {
        return new Frame(1, 0, 0, requireBytes(text));
    }

    /**
     * As {@link #of(String)}, of a command. A board searches a damaged frame for others, and one that does not fit its memory, so the text
     * of a command must not hold what a frame begins with.
     *
     * @throws IllegalArgumentException also if the text holds {@code fffe} or {@code fffd} and two hexadecimal digits
     */
    public static Frame ofCommand(String text) {
        Matcher header = HEADER.matcher(text);
        if (header.find()) {
            throw new IllegalArgumentException(
                    "the command " + quoted(text) + " holds " + quoted(header.group()) + " from character "
                            + (header.start() + 1)
                            + " on, which a board may take for the beginning of another command; leave it out, "
                            + "or put a character in between");
        }
        return of(text);
    }

    /**
     * The version 1 frame that carries a copy of {@code payload}.
     *
     * @throws IllegalArgumentException if the payload has more than {@value #MAX_PAYLOAD} bytes
     */
    public static Frame of(byte[] payload) {
        return new Frame(1, 0, 0, new String(payload, StandardCharsets.ISO_8859_1));
    }

    /**
     * The version 2 frame that carries a copy of {@code payload}.
     *
     * @param flags 0, or the sum of some of {@link #MORE}, {@link #ACK_WANTED}, {@link #ACK} and {@link #REFUSAL}
     * @param sequence the sender's count of frames modulo 16; a frame that is sent again has the same, an acknowledgement its action's
     * @throws IllegalArgumentException if the payload has more than {@value #MAX_PAYLOAD} bytes, or another argument is not 0 to 15
     */
    public static Frame version2(byte[] payload, int flags, int sequence) {
        return new Frame(2, flags, sequence, new String(payload, StandardCharsets.ISO_8859_1));
    }

    /** The frame of these fields that carries a copy of {@code length} bytes of {@code source}. */
    static Frame copyOf(int version, int flags, int sequence, byte[] source, int offset, int length) {
        return new Frame(version, flags, sequence, new String(source, offset, length, StandardCharsets.ISO_8859_1));
    }

    /** This frame's payload as version 2 sends it; as {@link #version2(byte[], int, int)}. */
    Frame toVersion2(int flags, int sequence) {
        return new Frame(2, flags, sequence, text);
    }

    /**
     * The version 2 frames of one message of any length, in their order: at least one, all but the last flagged {@link #MORE}.
     *
     * @param sequence the first one's number, from 0 to {@link #SEQUENCES} - 1; the others count on
     */
    public static List<Frame> fragments(byte[] message, int sequence) {
        List<Frame> frames = new ArrayList<>();
        int from = 0;
        do {
            int to = Math.min(message.length, from + MAX_PAYLOAD);
            int flags = to < message.length ? MORE : 0;
            frames.add(copyOf(2, flags, (sequence + frames.size()) % SEQUENCES, message, from, to - from));
            from = to;
        } while (from < message.length);
        return frames;
    }

    /**
     * {@code text} itself.
     *
     * @throws IllegalArgumentException if it has a character above U+00FF, which does not fit into a byte
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

    /** {@code text} in quotes, for a message to a person: its beginning if it is long. */
    public static String quoted(String text) {
        return text.length() <= 40 ? '"' + text + '"' : '"' + text.substring(0, 40) + "...\"";
    }

    /** The version of the protocol that this frame is of: 1 or 2. */
    public int version() {
        return version;
    }

    /** The flags, a sum of {@link #MORE} and so on; version 1 has none: 0. */
    public int flags() {
        return flags;
    }

    /** The sequence number, 0 to 15; version 1 has none: 0. */
    public int sequence() {
        return sequence;
    }

    /** Whether the flag is set: one of {@link #MORE}, {@link #ACK_WANTED}, {@link #ACK} and {@link #REFUSAL}. */
    public boolean has(int flag) {
        return (flags & flag) != 0;
    }

    /** Bytes of payload. */
    int payloadLength() {
        return text.length();
    }

    /** A copy of the payload's bytes. */
    public byte[] payload() {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    /** The payload as text, one character a byte (ISO-8859-1). */
    public String text() {
        return text;
    }

    /** Bytes this frame takes on the line: its payload and what is around it, {@value #HEADER_LENGTH} in version 1 and 12 in version 2. */
    public int length() {
        return HEADER_LENGTH + (version == 2 ? VERSION_2_OVERHEAD : 0) + text.length();
    }

    /** The bytes for the line, in an array of the caller's own; digits are written in upper case. */
    public byte[] toBytes() {
        byte[] bytes = new byte[length()];
        Arrays.fill(bytes, 0, PREAMBLE_LENGTH - 1, (byte) 'f');
        bytes[PREAMBLE_LENGTH - 1] = (byte) (version == 1 ? 'e' : 'd');
        putDigits(bytes, PREAMBLE_LENGTH, 2, text.length());
        int before = version == 1 ? HEADER_LENGTH : HEADER_LENGTH_2;
        System.arraycopy(payload(), 0, bytes, before, text.length());
        if (version == 2) {
            putDigits(bytes, HEADER_LENGTH, 2, flags << 4 | sequence);
            int checked = HEADER_LENGTH_2 - PREAMBLE_LENGTH + text.length();
            putDigits(bytes, bytes.length - CRC_LENGTH, CRC_LENGTH, Crc16.of(bytes, PREAMBLE_LENGTH, checked));
        }
        return bytes;
    }

    private static void putDigits(byte[] bytes, int offset, int count, int value) {
        for (int i = 0; i < count; i++) {
            bytes[offset + i] = (byte) DIGITS[value >> 4 * (count - 1 - i) & 0xF];
        }
    }

    /** Whether {@code other} is a frame of the same bytes. */
    @Override
    public boolean equals(Object other) {
        return other instanceof Frame frame
                && version == frame.version
                && flags == frame.flags
                && sequence == frame.sequence
                && text.equals(frame.text);
    }

    @Override
    public int hashCode() {
        return 31 * (version << 8 | flags << 4 | sequence) + text.hashCode();
    }

    /** The frame as it is on the line, for logs and test reports. */
    @Override
    public String toString() {
        return new String(toBytes(), StandardCharsets.ISO_8859_1);
    }
}
