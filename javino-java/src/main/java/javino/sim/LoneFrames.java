package javino.sim;

import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import javino.Frame;

/**
 * Finds frames of version 1 on a line with a session of version 2: those alone that begin behind a silence, so that no text within a
 * damaged frame of version 2 is taken for one. Nothing is read twice. Times are nanoseconds of any one clock. One thread at a time.
 */
final class LoneFrames {
    private static final String PREAMBLE = "fffe";

    private final long timeoutNanos;
    private final Consumer<Frame> found;
    private final StringBuilder held = new StringBuilder();
    private long lastNanos; // of a byte of the frame that is held

    LoneFrames(long timeoutNanos, Consumer<Frame> found) {
        this.timeoutNanos = timeoutNanos;
        this.found = found;
    }

    /** Takes a byte that came {@code silenceNanos} after the one before. */
    void accept(byte octet, long now, long silenceNanos) {
        idle(now);
        if (held.isEmpty() && silenceNanos < timeoutNanos / 4) {
            return;
        }
        lastNanos = now;
        held.append((char) (octet & 0xFF));
        if (!fits()) {
            forget();
        } else if (isInPayload() && held.length() == Frame.HEADER_LENGTH + payloadLength()) {
            byte[] payload = held.substring(Frame.HEADER_LENGTH).getBytes(StandardCharsets.ISO_8859_1);
            forget();
            found.accept(Frame.of(payload));
        }
    }

    /** Gives up a frame that a silence has cut. */
    void idle(long now) {
        if (now - lastNanos > timeoutNanos) {
            forget();
        }
    }

    void forget() {
        held.setLength(0);
    }

    /** Whether a header has arrived and its payload has not ended. */
    boolean isInPayload() {
        return held.length() >= Frame.HEADER_LENGTH;
    }

    /** Nanoseconds from {@code now} until {@link #idle} has something to do; {@link Long#MAX_VALUE}: it has not. */
    long nanosUntilIdle(long now) {
        return held.isEmpty() ? Long.MAX_VALUE : Math.max(0, lastNanos + timeoutNanos + 1 - now);
    }

    private boolean fits() {
        int last = held.length() - 1;
        return last < PREAMBLE.length() ? held.charAt(last) == PREAMBLE.charAt(last)
                : last >= Frame.HEADER_LENGTH || Character.digit(held.charAt(last), 16) >= 0;
    }

    private int payloadLength() {
        return Integer.parseInt(held.substring(PREAMBLE.length(), Frame.HEADER_LENGTH), 16);
    }
}
