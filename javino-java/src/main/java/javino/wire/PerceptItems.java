package javino.wire;

/** The bytes that begin the items of an answer. */
final class PerceptItems {
    /** The number of different shape ids. */
    static final int MAX_IDS = 126;
    /** Begins a text that goes on in the next item. */
    static final char CONTINUED = 0x7E;
    /** Begins a text without an id. */
    static final char NO_ID = 0x7F;
    /** The first byte of an item with only digits is this value plus the shape's id. */
    static final char DIGITS = 0x80;
    /** The half byte that ends a run of digits. */
    static final int END_OF_RUN = 0xF;
    /** The most bytes of text, or the most percepts sent as digits, in one item. */
    static final int MAX_LENGTH = 255;

    private PerceptItems() {}
}
