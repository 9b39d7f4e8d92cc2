package javino;

import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import javino.wire.FrameKind;
import javino.wire.WireDecoder;
import javino.wire.WireFrame;

/** Finds the frames that a computer sends to a board, in both versions. Times are nanoseconds of one clock. Not thread-safe. */
public final class BoardReceiver {
    /** A frame of one version. The field of the other version is null. */
    public record Found(Frame version1, WireFrame version2) {
        /**
         * Returns the nonce that is valid after this frame. HELLO begins a session with its nonce. A frame of version 1 ends the session:
         * the result is 0. After any other frame the nonce does not change: the result is empty.
         */
        public OptionalInt nonceBehind() {
            if (version2 == null) {
                return OptionalInt.of(0);
            }
            return version2.kind() == FrameKind.HELLO ? OptionalInt.of(version2.number()) : OptionalInt.empty();
        }
    }

    private final Protocol reads;
    private final long timeoutNanos;
    private final IntSupplier nonce;
    private final WireDecoder version2;
    private final FrameDecoder version1;
    private long lastNanos;

    /**
     * @param reads the version whose frames are found, or both
     * @param timeoutNanos silence that ends a frame
     * @param longestPayload bytes of the longest payload in version 2
     * @param nonce gives the nonce of the session of version 2; 0: there is no session. During a session, the receiver finds frames of
     *     version 1 only after a silence
     */
    public BoardReceiver(
            Protocol reads, long timeoutNanos, int longestPayload, IntSupplier nonce, Consumer<Found> found) {
        this.reads = reads;
        this.timeoutNanos = timeoutNanos;
        this.nonce = nonce;
        version2 = new WireDecoder(
                false, timeoutNanos, longestPayload, nonce, frame -> found.accept(new Found(null, frame)));
        version1 = new FrameDecoder(timeoutNanos, reads == Protocol.V1 ? -1 : WireFrame.START, frame -> {
            found.accept(new Found(frame, null));
            setAnywhere();
        });
    }

    private void setAnywhere() {
        version1.anywhere(nonce.getAsInt() == 0);
    }

    /** Takes a byte that has arrived at {@code now}, after {@code silenceNanos} of silence. */
    public void accept(byte octet, long now, long silenceNanos) {
        idle(now);
        lastNanos = now;
        if (silenceNanos > timeoutNanos / 4 && !version1.isReading()) {
            version1.quiet(true);
        }
        put(octet);
    }

    /** Notes that nothing has arrived from the last byte until {@code now}. */
    public void idle(long now) {
        if (now - lastNanos > timeoutNanos) {
            while (!version1.isEmpty()) {
                version1.giveUp();
                readAgain(version1.takeOther());
            }
        }
        version2.idle(now);
    }

    /**
     * Returns the nanoseconds from {@code now} after which {@link #idle} must be called. Returns {@link Long#MAX_VALUE} if no call is
     * needed.
     */
    public long nanosUntilIdle(long now) {
        return version1.isReading() || version2.isInFrame()
                ? Math.max(0, lastNanos + timeoutNanos + 1 - now)
                : Long.MAX_VALUE;
    }

    private void put(byte octet) {
        if (reads == Protocol.V2 || version2.isInFrame()) {
            put2(octet);
        } else {
            setAnywhere();
            version1.acceptUnbroken(new byte[] {octet}, 0, 1, lastNanos);
            readAgain(version1.takeOther());
        }
    }

    /** Handles bytes that the decoder of version 1 did not use. The first byte begins a frame of version 2. */
    private void readAgain(byte[] rest) {
        for (int i = 0; i < rest.length; i++) {
            if (i == 0) {
                put2(rest[i]);
            } else {
                put(rest[i]);
            }
        }
    }

    private void put2(byte octet) {
        version2.accept(octet, lastNanos);
        boolean isAnywhere = nonce.getAsInt() == 0;
        version1.anywhere(isAnywhere);
        version1.quiet(isAnywhere);
    }
}
