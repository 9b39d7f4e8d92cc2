package javino;

/**
 * Settings of a serial line: 8 data bits, no parity, 1 stop bit, no flow control.
 *
 * @param baud bits a second, at least 1; most boards use 9600
 */
public record LineSettings(int baud) {
    /** The baud rate of a board whose settings give none. */
    public static final int DEFAULT_BAUD = 9600;

    /** A line without a baud rate, as in a network. A byte takes 0.1 µs, so no frame waits for the line. */
    public static final LineSettings NETWORK = new LineSettings(100_000_000);

    private static final long BITS_PER_BYTE = 10; // a start bit, eight of data, a stop bit
    private static final long NANOS_PER_SECOND = 1_000_000_000L;

    public LineSettings {
        if (baud < 1) {
            throw new IllegalArgumentException("a line's rate is at least 1 baud, but " + baud + " was asked for");
        }
    }

    /** Returns settings with 9600 baud. */
    public static LineSettings defaults() {
        return new LineSettings(DEFAULT_BAUD);
    }

    /** Returns the nanoseconds that one byte takes on the line: ten bit times. */
    public long byteNanos() {
        return BITS_PER_BYTE * NANOS_PER_SECOND / baud;
    }
}
