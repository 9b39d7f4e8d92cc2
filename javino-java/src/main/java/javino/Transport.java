package javino;

/**
 * An open line that carries bytes both ways.
 *
 * <p>One thread may read while another writes. Any thread may call {@link #close()}, even while others wait. If the line is closed or its
 * device has gone, every call except {@code close} throws {@link PortGoneException} at once. If a waiting thread is interrupted, its call
 * throws {@link PortInterruptedException} and the thread stays marked as interrupted. Bytes of an interrupted write may still go out.
 */
public interface Transport extends AutoCloseable {
    /** Returns the port's name for messages: {@code ttyACM0}, {@code sim:robot}. */
    String name();

    /** Returns the settings with which this line was opened. */
    LineSettings line();

    /** Returns whether the far end may vanish without an error, as in a network. If so, callers reopen the line after a long silence. */
    default boolean mayVanish() {
        return false;
    }

    /** Returns a question for a person: what to check if the board does not answer. */
    default String doubt() {
        int baud = line().baud();
        return "does the board run a Javino sketch at " + baud + " baud, with javino.start(" + baud
                + ") in setup() and javino.run() in "
                + "loop()? A loop() that waits, as with delay(3000), answers too late";
    }

    /**
     * Waits until at least one byte has arrived, then returns the available bytes.
     *
     * @param b the array to fill from {@code off}
     * @param len the most bytes to read, at least 1
     * @param timeoutMillis milliseconds to wait at most; 0: do not wait
     * @return number of bytes read, 1 to {@code len}; 0 if no byte arrived in time
     * @throws PortGoneException if the line is closed, or its device has gone. A read notices a lost device within a second
     */
    int read(byte[] b, int off, int len, int timeoutMillis) throws PortException;

    /**
     * Hands bytes to the driver and returns when the driver has taken them all. The bytes may reach the wire later.
     *
     * @param timeoutMillis milliseconds to wait at most for the driver; 0: the calling thread calls the driver directly. Pass 0 only
     *     after {@link #isWritableNow} has returned true
     * @throws PortTimeoutException if the driver has not taken all bytes in time; some bytes may have gone out
     * @throws PortGoneException if the line is closed, or its device has gone
     */
    void write(byte[] b, int off, int len, int timeoutMillis) throws PortException;

    /** Length in bytes of the longest frame if every byte is escaped. */
    int LONGEST_FRAME = 600;

    /**
     * Returns whether {@link #write} certainly hands a frame of {@value #LONGEST_FRAME} bytes to the driver without waiting, if no other
     * thread writes. The line must know its free buffer space, or the {@code unread} bytes must leave room in the smallest buffer that
     * the line may have. Safe on any thread. Does not wait.
     *
     * @param unread number of the last written bytes that the far end may not have read. Only answers prove that the far end has read
     *     bytes
     */
    default boolean isWritableNow(long unread) {
        return false;
    }

    /** Closes the line and releases its device. Waiting calls throw {@link PortGoneException}. Idempotent. */
    @Override
    void close();
}
