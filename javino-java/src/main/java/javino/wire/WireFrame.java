package javino.wire;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/**
 * A frame of version 2.
 *
 * @param isRefused set by a board: the last command was refused, and later commands wait
 * @param isBusy set by a board: the board is carrying out the next command
 * @param number the byte SS, 0 to 255. From a computer: the number of a command, a request or a session. From a board: the number of the
 *     next command
 * @param payload 0 to {@value #MAX_PAYLOAD} characters, each a byte
 */
public record WireFrame(FrameKind kind, boolean isRefused, boolean isBusy, int number, String payload) {
    /** The longest payload, in bytes. */
    public static final int MAX_PAYLOAD = 255;

    /** Number of bytes around a payload. */
    public static final int OVERHEAD = 6;

    /** The byte that begins a frame. This byte appears nowhere else in a frame. */
    public static final int START = 0xA5;

    static final int ESCAPE = 0xA4;
    static final int ESCAPED = 0xA0; // added to the byte after ESCAPE
    static final int REFUSED = 0x40;
    static final int BUSY = 0x20;

    public WireFrame {
        if (payload.length() > MAX_PAYLOAD) {
            throw new IllegalArgumentException(
                    "a payload has at most " + MAX_PAYLOAD + " bytes, but this has " + payload.length());
        }
        if (number < 0 || number > 0xFF) {
            throw new IllegalArgumentException("a number is 0 to 255, but " + number + " was given");
        }
        if ((isRefused || isBusy) && !kind.isFromBoard()) {
            throw new IllegalArgumentException("only a board refuses or is busy, but the frame is " + kind);
        }
    }

    /** A frame without flags. */
    public static WireFrame of(FrameKind kind, int number, String payload) {
        return new WireFrame(kind, false, false, number, payload);
    }

    /** Returns the number of bytes of the frame without escapes. */
    public int length() {
        return OVERHEAD + payload.length();
    }

    /**
     * Returns the frame's bytes in a new array.
     *
     * @param nonce the session's nonce, 0 to 255; HELLO and WELCOME do not depend on it
     */
    public byte[] toBytes(int nonce) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream(length() + 2);
        Crc16 crc = new Crc16();
        crc.reset(kind.isOfNoSession() ? 0 : nonce);
        bytes.write(START);
        putChecked(bytes, crc, payload.length());
        putChecked(bytes, crc, kind.code() | (isRefused ? REFUSED : 0) | (isBusy ? BUSY : 0));
        putChecked(bytes, crc, number);
        for (byte octet : payload.getBytes(StandardCharsets.ISO_8859_1)) {
            putChecked(bytes, crc, octet);
        }
        put(bytes, crc.value() >> 8);
        put(bytes, crc.value() & 0xFF);
        return bytes.toByteArray();
    }

    private static void putChecked(ByteArrayOutputStream bytes, Crc16 crc, int octet) {
        crc.add(octet);
        put(bytes, octet & 0xFF);
    }

    private static void put(ByteArrayOutputStream bytes, int octet) {
        if (octet == START || octet == ESCAPE) {
            bytes.write(ESCAPE);
            bytes.write(octet - ESCAPED);
        } else {
            bytes.write(octet);
        }
    }
}
