package javino;

/**
 * An open line that carries bytes both ways.
 *
 * <p>One thread may read while another writes. {@link #close()} may be called from any thread, also while others wait. If the line is
 * closed or its device has gone, every call but {@code close} throws {@link PortGoneException} at once. A waiting thread that is
 * interrupted gets {@link PortInterruptedException} and stays interrupted; bytes that it was writing may still leave.
 */
public interface Transport extends AutoCloseable {
    /** The port's name as a person would give it, for messages: {@code ttyACM0}, {@code sim:robot}. */
    String name();

    /** The settings with which this line was opened. */
    LineSettings line();

    /** Returns whether the far end may vanish unnoticed, as in a network. Such a line is worth reopening after a long silence. */
    default boolean mayVanish() {
        return false;
    }

    /** A question that tells a person what to check if the board does not answer. */
    default String doubt() {
        int baud = line().baud();
        return "does the board run a Javino sketch at " + baud + " baud, with javino.start(" + baud
                + ") in setup() and javino.run() in "
                + "loop()? A loop() that waits, as with delay(3000), answers too late";
    }

    /**
     * Waits until at least one byte has arrived, then takes the bytes that are there.
     *
     * @param b the array to fill from {@code off}
     * @param len the most bytes to read, at least 1
     * @param timeoutMillis milliseconds to wait at most; 0 takes only bytes that are there already
     * @return bytes read, 1 to {@code len}, or 0 when the time is over
     * @throws PortGoneException if the line is closed, or its device has gone; a lost device is noticed within a second
     */
    int read(byte[] b, int off, int len, int timeoutMillis) throws PortException;

    /**
     * Hands bytes to the line and returns when the driver has taken them all. The bytes may leave later.
     *
     * @param timeoutMillis milliseconds to wait at most while the driver takes no more; 0: the calling thread calls the driver itself,
     *     after it has found that the line {@linkplain #isWritableNow takes a frame now}
     * @throws PortTimeoutException if the driver has not taken all bytes in that time; some may have left
     * @throws PortGoneException if the line is closed, or its device gone
     */
    void write(byte[] b, int off, int len, int timeoutMillis) throws PortException;

    /** Bytes of the longest frame, with every byte escaped. */
    int LONGEST_FRAME = 600;

    /**
     * Returns whether {@link #write} certainly hands a frame of {@value #LONGEST_FRAME} bytes to the driver without a wait, while no other
     * thread writes. This is certain if the line knows its room, or if the {@code unread} bytes leave room in the smallest buffer that the
     * line may have. Safe on any thread; does not wait.
     *
     * @param unread number of the last written bytes that the far end may not have read. Only answers prove that the far end has read bytes
     */
    default boolean isWritableNow(long unread) {
        return false;
    }

    /** Closes the line and gives its device back. Calls that wait on it throw {@link PortGoneException}. Idempotent. */
    @Override
    void close();
}
