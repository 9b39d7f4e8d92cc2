package javino;

import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Finds frames of version 1 in any bytes that a line brings.
 *
 * <p>A frame is handed over as soon as its last byte is in. Version 1 has no checksum, so a damaged frame may have swallowed the beginning
 * of the next one. So the decoder keeps a frame's bytes until it knows the bytes behind the frame:
 * <ul>
 *   <li>the header of another frame, or silence, confirms the frame, and its bytes are forgotten;
 *   <li>anything else puts the frame in doubt: the decoder reads the frame's bytes again from the second on, with the bytes behind it, and
 *       hands over the intact frames that it finds.
 * </ul>
 * So an intact stream gives exactly its frames, whatever text they carry, and a damaged frame does not cost the intact one behind it.
 *
 * <p>If the line is silent for longer than the inter-byte timeout, an unfinished frame is given up; complete frames among its bytes are
 * handed over. The decoder holds about two frames at most, and no input makes it throw. Exceptions of the receiver pass through; the
 * decoder stays usable.
 *
 * <p>Time is a parameter, in nanoseconds of any steady clock. One thread at a time; the receiver must not call back into the decoder.
 */
public final class FrameDecoder {
    private static final long LEAST_INTER_BYTE_NANOS = 100_000_000L;
    private static final int INTER_BYTE_TIMES = 20;
    private static final int LONGEST = Frame.HEADER_LENGTH + Frame.MAX_PAYLOAD;
    private static final int PREAMBLE_END = 3;
    private static final int LENGTH_AT = 4;
    /** Room for two of the longest frames, each with an unfinished header behind it, so bytes are seldom moved. */
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
    private int start; // held[start..end) are the bytes not yet decided on
    private int end;
    private int delivered; // length of the frame at start if it was handed over but is not confirmed, else 0
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
     * A decoder for a line that also carries frames of another protocol. The decoder stops at the first byte of such a frame, which the
     * caller {@link #takeOther takes}.
     *
     * @param other the byte that begins a frame of the other protocol, except within a payload of version 1; -1: there is no other protocol
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

    /** The usual inter-byte timeout of a line: 100 ms, or 20 byte times if that is longer. */
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

    /** Takes bytes that arrived at an unknown time up to {@code nowNanos}; no silence is assumed before them. */
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

    /** Notes that nothing has arrived up to {@code nowNanos}; an unfinished frame may be given up. */
    public void idle(long nowNanos) {
        if (end > start && nowNanos - lastByteNanos > interByteTimeoutNanos) {
            giveUp();
        }
    }

    /**
     * Nanoseconds of silence from {@code nowNanos} after which {@link #idle} has something to decide; {@link Long#MAX_VALUE}: silence
     * changes nothing. A thread that waits for bytes must wake after this silence and call {@code idle}.
     */
    public long nanosUntilIdle(long nowNanos) {
        return isReading() ? Math.max(0, lastByteNanos + interByteTimeoutNanos + 1 - nowNanos) : Long.MAX_VALUE;
    }

    /** Forgets all held bytes, as if the next byte were the line's first. The counts stay. */
    public void reset() {
        discarded += end - start - delivered;
        clear();
    }

    /** Frames handed over so far. */
    public long frames() {
        return frames;
    }

    /** The number of bytes so far that belonged to no frame, or to a frame that was put in doubt. */
    public long discarded() {
        return discarded;
    }

    /** Sets where frames may begin from now on: at any byte, or only right after a silence, see {@link #quiet}. */
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

    /** Removes and returns all held bytes if they begin with a frame of the other protocol; else returns no bytes. */
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

    /** Decides on as many bytes as possible. What stays is the beginning of a frame, or a frame to be confirmed. */
    private void decide() {
        boolean progress = true;
        while (progress && start < end && !isOtherAt(start)) {
            progress = delivered > 0 ? confirmOrDoubt() : deliverOrSkip();
        }
    }

    /** Like the methods that it calls, returns whether anything was decided. */
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

    /** Decides on all held bytes after a silence: an unfinished frame among them is given up. */
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
