package javino.wire;

import java.util.function.Consumer;
import java.util.function.IntSupplier;

/** Finds the frames of one direction and one session in arriving bytes. Times are nanoseconds of one clock. Not thread-safe. */
public final class WireDecoder {
    private static final int PAYLOAD_AT = 3; // after length, kind and number
    private static final int CRC_LENGTH = 2;

    private final boolean fromBoard;
    private final long timeoutNanos;
    private final int longestPayload;
    private final IntSupplier nonce;
    private final Consumer<WireFrame> found;
    private final StringBuilder content = new StringBuilder(); // length, kind, number and payload, without escapes
    private boolean isInFrame;
    private boolean isEscaped;
    private int checksum; // the received part of the checksum
    private int checksumBytes;
    private long lastByteNanos;
    private long damaged;
    private long corrupt;

    /**
     * @param fromBoard true: a board sends the frames; false: a computer sends the frames
     * @param timeoutNanos silence that ends a frame
     * @param nonce gives the nonce of the session when a frame ends; 0: there is no session. Without a session a board checks only the
     *     checksum of HELLO, and finds all other frames. A computer without a session finds only WELCOME
     * @param found takes each frame, on the thread that passes in the frame's last byte
     */
    public WireDecoder(boolean fromBoard, long timeoutNanos, IntSupplier nonce, Consumer<WireFrame> found) {
        this(fromBoard, timeoutNanos, WireFrame.MAX_PAYLOAD, nonce, found);
    }

    /** Like the other constructor, but a frame with a payload of more than {@code longestPayload} bytes counts as damaged. */
    public WireDecoder(
            boolean fromBoard, long timeoutNanos, int longestPayload, IntSupplier nonce, Consumer<WireFrame> found) {
        this.fromBoard = fromBoard;
        this.timeoutNanos = timeoutNanos;
        this.longestPayload = longestPayload;
        this.nonce = nonce;
        this.found = found;
    }

    /** Takes {@code count} bytes without a silence between them. The last byte arrived at {@code now}. */
    public void accept(byte[] bytes, int offset, int count, long now) {
        for (int i = offset; i < offset + count; i++) {
            accept(bytes[i], now);
        }
    }

    /** Takes bytes that arrived at an unknown time up to {@code now}. Assumes no silence before the bytes. */
    public void acceptUnbroken(byte[] bytes, int offset, int count, long now) {
        lastByteNanos = now;
        accept(bytes, offset, count, now);
    }

    /** Takes one byte. Returns whether the byte belongs to a frame of version 2, whole or damaged. */
    public boolean accept(byte octet, long now) {
        idle(now);
        lastByteNanos = now;
        int value = octet & 0xFF;
        if (value == WireFrame.START) {
            begin();
            return true;
        }
        boolean belongs = isInFrame;
        if (isInFrame) {
            read(value);
        }
        return belongs;
    }

    /** Notes that nothing has arrived from the last byte until {@code now}. A silence ends an unfinished frame. */
    public void idle(long now) {
        if (isInFrame && now - lastByteNanos > timeoutNanos) {
            drop();
        }
    }

    /**
     * Returns the nanoseconds from {@code now} after which {@link #idle} must be called. Returns {@link Long#MAX_VALUE} outside of a
     * frame.
     */
    public long nanosUntilIdle(long now) {
        return isInFrame ? Math.max(0, lastByteNanos + timeoutNanos + 1 - now) : Long.MAX_VALUE;
    }

    /** Returns whether a frame has begun and not ended. */
    public boolean isInFrame() {
        return isInFrame;
    }

    /** Returns the number of damaged frames so far. */
    public long damaged() {
        return damaged;
    }

    /** Returns the number of frames so far with a wrong checksum for their session. */
    public long corrupt() {
        return corrupt;
    }

    private void begin() {
        if (isInFrame) {
            damaged++;
        }
        isInFrame = true;
        isEscaped = false;
        content.setLength(0);
        checksum = 0;
        checksumBytes = 0;
    }

    private void drop() {
        damaged++;
        isInFrame = false;
    }

    private void read(int value) {
        if (isEscaped) {
            isEscaped = false;
            int original = value + WireFrame.ESCAPED;
            if (original == WireFrame.ESCAPE || original == WireFrame.START) {
                take(original);
            } else {
                drop();
            }
        } else if (value == WireFrame.ESCAPE) {
            isEscaped = true;
        } else {
            take(value);
        }
    }

    private void take(int value) {
        if (content.length() < PAYLOAD_AT || content.length() < PAYLOAD_AT + content.charAt(0)) {
            content.append((char) value);
            if (content.charAt(0) > longestPayload || content.length() == 2 && kind() == null) {
                drop();
            }
            return;
        }
        checksum = checksum << 8 | value;
        if (++checksumBytes == CRC_LENGTH) {
            end();
        }
    }

    private FrameKind kind() {
        int control = content.charAt(1);
        boolean isBoards = (control & FrameKind.FROM_BOARD) != 0;
        return isBoards == fromBoard
                ? FrameKind.of(isBoards ? control & ~(WireFrame.REFUSED | WireFrame.BUSY) : control)
                : null;
    }

    private void end() {
        FrameKind kind = kind();
        int session = kind.isOfNoSession() ? 0 : nonce.getAsInt();
        boolean isChecked = kind.isOfNoSession() || session != 0;
        if (isChecked && checksum != crcOf(session)) {
            corrupt++;
            drop();
            return;
        }
        isInFrame = false;
        if (!isChecked && fromBoard) {
            return;
        }
        int control = content.charAt(1);
        boolean isRefused = fromBoard && (control & WireFrame.REFUSED) != 0;
        boolean isBusy = fromBoard && (control & WireFrame.BUSY) != 0;
        found.accept(new WireFrame(kind, isRefused, isBusy, content.charAt(2), content.substring(PAYLOAD_AT)));
    }

    private int crcOf(int session) {
        Crc16 crc = new Crc16();
        crc.reset(session);
        content.chars().forEach(crc::add);
        return crc.value();
    }
}
