package javino;

import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Finds frames of version 1 in the bytes from a line.
 *
 * <p>The decoder delivers a frame as soon as the frame's last byte has arrived. Version 1 has no checksum, so a damaged frame may contain
 * the beginning of the next frame. The decoder therefore keeps a delivered frame's bytes until it knows the following bytes:
 * <ul>
 *   <li>If silence or the header of another frame follows, the decoder forgets the bytes.
 *   <li>If anything else follows, the frame is in doubt. The decoder searches the frame's bytes again from the second on, and delivers
 *       the intact frames in them.
 * </ul>
 * An intact stream gives exactly its frames, with any text in them. A damaged frame does not cost the intact frame after it.
 *
 * <p>If the line is silent for longer than the inter-byte timeout, the decoder gives up an unfinished frame. The decoder then delivers
 * the complete frames among the unfinished frame's bytes. The decoder holds about two frames at most. No input makes the decoder throw.
 * It passes the receiver's exceptions on and stays usable.
 *
 * <p>Times are nanoseconds of any steady clock. Not thread-safe. The receiver must not call the decoder.
 */
public final class FrameDecoder {
    private static final long LEAST_INTER_BYTE_NANOS = 100_000_000L;
    private static final int INTER_BYTE_TIMES = 20;
    private static final int LONGEST = Frame.HEADER_LENGTH + Frame.MAX_PAYLOAD;
    private static final int PREAMBLE_END = 3;
    private static final int LENGTH_AT = 4;
    /** Two of the longest frames, each followed by an unfinished header, fit. The decoder therefore seldom moves bytes. */
    private static final int CAPACITY = 2 * (LONGEST + Frame.HEADER_LENGTH);

    private enum Header {
        IMPOSSIBLE,
        UNFINISHED,
        COMPLETE
    }

    private static final int NONE = -1;

    private final long interByteTimeoutNanos;
    private final int other;
    private final Consumer<Frame> sink;
    private final byte[] held = new byte[CAPACITY];
    private int start; // held[start..end) are the undecided bytes
    private int end;
    private int delivered; // length of the frame at start if it is delivered but not confirmed, else 0
    private long lastByteNanos;
    private long frames;
    private long discarded;
    private boolean isAnywhere = true;
    private boolean isQuiet = true;

    /**
     * @param interByteTimeoutNanos the silence that ends an unfinished frame, at least 1 ns
     * @param sink receives each frame, on the thread that feeds the decoder
     */
    public FrameDecoder(long interByteTimeoutNanos, Consumer<Frame> sink) {
        this(interByteTimeoutNanos, NONE, sink);
    }

    /**
     * Creates a decoder for a line that also carries frames of another protocol. The decoder stops at the first byte of the other
     * protocol's frame. The caller then {@linkplain #takeOther takes} the bytes.
     *
     * @param other the byte that begins a frame of the other protocol outside of version 1 payloads; -1: there is no other protocol
     */
    FrameDecoder(long interByteTimeoutNanos, int other, Consumer<Frame> sink) {
        if (interByteTimeoutNanos < 1) {
            throw new IllegalArgumentException(
                    "an inter-byte timeout is at least 1 ns, but " + interByteTimeoutNanos + " was given");
        }
        this.interByteTimeoutNanos = interByteTimeoutNanos;
        this.other = other;
        this.sink = sink;
    }

    /** Returns the usual inter-byte timeout of a line: 100 ms, or 20 byte times if they take longer. */
    public static long interByteTimeoutNanos(LineSettings line) {
        return Math.max(LEAST_INTER_BYTE_NANOS, INTER_BYTE_TIMES * line.byteNanos());
    }

    /** Takes bytes that arrived together at {@code nowNanos}. */
    public void accept(byte[] b, int off, int len, long nowNanos) {
        if (len > 0) {
            idle(nowNanos);
            acceptUnbroken(b, off, len, nowNanos);
        }
    }

    /** Takes bytes that arrived at an unknown time up to {@code nowNanos}. Assumes no silence before the bytes. */
    public void acceptUnbroken(byte[] b, int off, int len, long nowNanos) {
        lastByteNanos = nowNanos;
        for (int i = off; i < off + len; i++) {
            append(b[i]);
        }
    }

    /** Takes one byte that arrived at {@code nowNanos}. */
    public void accept(byte b, long nowNanos) {
        accept(new byte[] {b}, 0, 1, nowNanos);
    }

    /** Notes that nothing has arrived up to {@code nowNanos}. The decoder may give up an unfinished frame. */
    public void idle(long nowNanos) {
        if (end > start && nowNanos - lastByteNanos > interByteTimeoutNanos) {
            giveUp();
        }
    }

    /**
     * Returns the nanoseconds from {@code nowNanos} after which {@link #idle} must be called, if no byte arrives. Returns
     * {@link Long#MAX_VALUE} if no call is needed.
     */
    public long nanosUntilIdle(long nowNanos) {
        return isReading() ? Math.max(0, lastByteNanos + interByteTimeoutNanos + 1 - nowNanos) : Long.MAX_VALUE;
    }

    /** Forgets all held bytes. The next byte counts as the line's first. The counts stay. */
    public void reset() {
        discarded += end - start - delivered;
        clear();
    }

    /** Returns the number of frames delivered so far. */
    public long frames() {
        return frames;
    }

    /** Returns the number of bytes so far that belonged to no frame, or to a frame in doubt. */
    public long discarded() {
        return discarded;
    }

    /** Sets whether a frame may begin at any byte, or only right after a silence; see {@link #quiet}. */
    void anywhere(boolean value) {
        isAnywhere = value;
    }

    void quiet(boolean value) {
        isQuiet = value;
    }

    boolean isReading() {
        return end - start > delivered;
    }

    boolean isEmpty() {
        return start == end;
    }

    /** If the held bytes begin with a frame of the other protocol, removes and returns them. Else returns an empty array. */
    byte[] takeOther() {
        if (!isOtherAt(start)) {
            return new byte[0];
        }
        byte[] taken = Arrays.copyOfRange(held, start, end);
        clear();
        return taken;
    }

    private boolean isOtherAt(int place) {
        return place < end && other != NONE && (held[place] & 0xFF) == other;
    }

    private void append(byte b) {
        if (end == CAPACITY) {
            System.arraycopy(held, start, held, 0, end - start);
            end -= start;
            start = 0;
        }
        held[end++] = b;
        decide();
    }

    /** Decides on as many bytes as possible. Keeps the beginning of a frame, or a frame that is not confirmed. */
    private void decide() {
        boolean progress = true;
        while (progress && start < end && !isOtherAt(start)) {
            progress = delivered > 0 ? confirmOrDoubt() : deliverOrSkip();
        }
    }

    /** Returns whether anything was decided. */
    private boolean confirmOrDoubt() {
        return switch (isOtherAt(start + delivered) ? Header.COMPLETE : headerAt(start + delivered)) {
            case COMPLETE -> confirm();
            case IMPOSSIBLE -> discardFirst();
            case UNFINISHED -> false;
        };
    }

    private boolean deliverOrSkip() {
        return switch (isQuiet ? headerAt(start) : Header.IMPOSSIBLE) {
            case COMPLETE -> deliver();
            case IMPOSSIBLE -> discardFirst();
            case UNFINISHED -> false;
        };
    }

    private boolean deliver() {
        int length = Frame.HEADER_LENGTH + payloadLength();
        if (end - start < length) {
            return false;
        }
        delivered = length;
        frames++;
        sink.accept(Frame.copyOf(held, start + Frame.HEADER_LENGTH, payloadLength()));
        isQuiet = isAnywhere;
        return true;
    }

    private boolean confirm() {
        start += delivered;
        delivered = 0;
        return true;
    }

    private boolean discardFirst() {
        start++;
        delivered = 0;
        discarded++;
        isQuiet = isAnywhere;
        return true;
    }

    /** Decides on all held bytes after a silence. Gives up an unfinished frame among them. */
    void giveUp() {
        while (end > start) {
            decide();
            if (isOtherAt(start)) {
                return;
            }
            if (isReading()) {
                discardFirst();
            } else {
                clear();
            }
        }
    }

    private void clear() {
        start = 0;
        end = 0;
        delivered = 0;
    }

    private Header headerAt(int from) {
        int known = Math.min(end - from, Frame.HEADER_LENGTH);
        for (int i = 0; i < known; i++) {
            if (!fits(i, held[from + i])) {
                return Header.IMPOSSIBLE;
            }
        }
        return known == Frame.HEADER_LENGTH ? Header.COMPLETE : Header.UNFINISHED;
    }

    private boolean fits(int position, byte b) {
        return switch (position) {
            case 0, 1, 2 -> b == 'f';
            case PREAMBLE_END -> b == 'e';
            default -> digit(b) >= 0;
        };
    }

    private int payloadLength() {
        return digit(held[start + LENGTH_AT]) << 4 | digit(held[start + LENGTH_AT + 1]);
    }

    private static int digit(byte b) {
        return Character.digit(b & 0xFF, 16);
    }
}
