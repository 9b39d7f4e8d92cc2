package javino;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.LongConsumer;

/** Reads a line on the caller's thread and keeps the messages that came. One thread at a time. */
final class Inbox {
    private static final long NANOS_PER_MILLI = 1_000_000L;
    private static final int BUFFER = 1024;
    /** Reads at most, one after the other, of what a line has ready: more than any driver holds, but an end for a line that never rests. */
    private static final int READS = 64;

    private final Deque<Frame> messages = new ArrayDeque<>();
    private final byte[] buffer = new byte[BUFFER];
    private final Transport transport;
    private final LineClock clock;
    private final FrameDecoder decoder;
    private final LongConsumer received;
    private long lastByteNanos;

    /** @param received told the time whenever bytes have arrived */
    Inbox(Transport transport, LineClock clock, LongConsumer received) {
        this.transport = transport;
        this.clock = clock;
        this.received = received;
        decoder = new FrameDecoder(FrameDecoder.interByteTimeoutNanos(transport.line()), messages::add);
        lastByteNanos = clock.nanos();
    }

    /** The next message, or null if none is complete when the clock shows {@code deadlineNanos}; one that has passed does not wait. */
    Frame next(long deadlineNanos) throws PortException {
        while (messages.isEmpty()) {
            long now = clock.nanos();
            long left = Math.max(0, deadlineNanos - now);
            readFor(Math.min(left, decoder.nanosUntilIdle(now)));
            if (left == 0) {
                break;
            }
        }
        return messages.poll();
    }

    /** Reads what the line has ready, and returns the newest message among that and what was read before, or null. */
    Frame newest() throws PortException {
        for (int reads = 0; reads < READS && readFor(0) > 0; reads++) { }
        Frame newest = messages.peekLast();
        messages.clear();
        return newest;
    }

    /** Reads what the line has ready, and forgets it with all that was read before, unfinished messages too. */
    void clear() throws PortException {
        newest();
        decoder.reset();
    }

    /** When the last byte arrived. */
    long lastByteNanos() {
        return lastByteNanos;
    }

    private int readFor(long nanos) throws PortException {
        long millis = nanos / NANOS_PER_MILLI + (nanos % NANOS_PER_MILLI > 0 ? 1 : 0);
        int count = transport.read(buffer, 0, BUFFER, (int) Math.min(millis, Integer.MAX_VALUE));
        long now = clock.nanos();
        if (count > 0) {
            lastByteNanos = now;
            decoder.acceptUnbroken(buffer, 0, count, now); // a read that finds nothing tells of silence, a late one does not
            received.accept(now);
        } else {
            decoder.idle(now);
        }
        return count;
    }
}
