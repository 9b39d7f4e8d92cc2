package javino.sim;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javino.Frame;
import javino.FrameDecoder;
import javino.Protocol;
import javino.wire.FrameKind;
import javino.wire.WireDecoder;
import javino.wire.WireFrame;

/**
 * Finds what a computer sends to a board on a line that both versions of the protocol may share. Times are nanoseconds of any one clock.
 * One thread at a time.
 */
final class BoardReceiver {
    /** What was found: one of both. */
    record Found(Frame version1, WireFrame version2) {
        boolean isHello() {
            return version2 != null && version2.kind() == FrameKind.HELLO;
        }
    }

    private final Protocol reads;
    private final BooleanSupplier hasSession;
    private final WireDecoder version2;
    private final FrameDecoder version1; // without a session
    private final LoneFrames lone; // of version 1, in a session

    /**
     * @param reads the version whose frames are found, or both
     * @param timeoutNanos silence that ends a frame
     * @param longestPayload bytes of payload of version 2
     * @param hasSession whether there is a session of version 2 when a byte arrives
     */
    BoardReceiver(Protocol reads, long timeoutNanos, int longestPayload, BooleanSupplier hasSession, Consumer<Found> found) {
        this.reads = reads;
        this.hasSession = hasSession;
        version2 = new WireDecoder(false, timeoutNanos, longestPayload, frame -> found.accept(new Found(null, frame)));
        version1 = new FrameDecoder(timeoutNanos, frame -> found.accept(new Found(frame, null)));
        lone = new LoneFrames(timeoutNanos, frame -> found.accept(new Found(frame, null)));
    }

    /**
     * Takes a byte that has arrived at {@code now}.
     *
     * @param silenceNanos for how long nothing came before it
     */
    void accept(byte octet, long now, long silenceNanos) {
        idle(now);
        boolean isPayload = version1.isInPayload() || lone.isInPayload();
        if (reads != Protocol.V1 && !isPayload && version2.accept(octet, now)) {
            version1.reset();
            lone.forget();
        } else if (reads == Protocol.V2) {
            return;
        } else if (hasSession.getAsBoolean()) {
            lone.accept(octet, now, silenceNanos);
        } else {
            version1.accept(octet, now);
        }
    }

    /** Notes that nothing has arrived since the last byte. */
    void idle(long now) {
        version1.idle(now);
        version2.idle(now);
        lone.idle(now);
    }

    /** Nanoseconds from {@code now} until {@link #idle} has something to decide; {@link Long#MAX_VALUE}: it has not. */
    long nanosUntilIdle(long now) {
        return Math.min(version1.nanosUntilIdle(now), Math.min(version2.nanosUntilIdle(now), lone.nanosUntilIdle(now)));
    }
}
