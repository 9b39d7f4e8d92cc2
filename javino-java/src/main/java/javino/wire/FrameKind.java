package javino.wire;

import java.util.Arrays;

/** The purpose of a frame of version 2. */
public enum FrameKind {
    /** Begins a session; the number of the frame is the session's nonce. */
    HELLO(0x10),
    /** Requests percepts. */
    ASK(0x20),
    /** Requests a page of the vocabulary. */
    DESCRIBE(0x28),
    /** Commands. The first command has the frame's number. Each further command has the next number. */
    COMMANDS(0x30),
    /** Like {@link #COMMANDS}. Also tells the board that the computer has seen the refusal of a command. */
    COMMANDS_WITH_RESUME(0x31),

    /** The answer to {@link #HELLO}. Also tells that the board has no session. */
    WELCOME(0x80),
    /** The answer to commands. */
    ACK(0x81),
    /** A whole answer, or percepts sent unasked. */
    PERCEPTS(0x82),
    /** A part of an answer of several parts, but not the last. */
    PERCEPTS_PART(0x83),
    /** The last part of an answer of several parts. */
    PERCEPTS_LAST(0x84),
    /** A report that a rule on the board begins to match. */
    CRITICAL(0x85),
    /** A page of the vocabulary. */
    VOCABULARY(0x86);

    static final int FROM_BOARD = 0x80;

    private static final FrameKind[] BY_CODE = new FrameKind[256];

    static {
        Arrays.stream(values()).forEach(kind -> BY_CODE[kind.code] = kind);
    }

    private final int code;

    FrameKind(int code) {
        this.code = code;
    }

    int code() {
        return code;
    }

    /** Returns whether the board sends frames of this kind. Otherwise the computer does. */
    public boolean isFromBoard() {
        return (code & FROM_BOARD) != 0;
    }

    /** Returns whether the checksum of this kind does not depend on the session. */
    boolean isOfNoSession() {
        return this == HELLO || this == WELCOME;
    }

    /** Returns the kind for a control byte without flags, or null. */
    static FrameKind of(int code) {
        return BY_CODE[code];
    }
}
