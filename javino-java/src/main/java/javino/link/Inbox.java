package javino.link;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import javino.Frame;
import javino.FrameDecoder;
import javino.LineClock;
import javino.PortException;
import javino.Protocol;
import javino.Transport;
import javino.wire.WireDecoder;
import javino.wire.WireFrame;

/**
 * Reads a line. Passes frames of version 2 on, and keeps messages of version 1 until a caller takes them.
 * <p>One of the waiting threads reads for all. When the reader's wait ends, another thread reads.
 */
final class Inbox {
    /** Receives what arrives, under the monitor's lock. Times are nanoseconds of the line's clock. */
    interface Listener {
        void receiving(int bytes, long now);

        default void received(WireFrame frame, long now) {}

        /** Returns the nonce of the present session, see {@link WireDecoder}. */
        default int nonce() {
            return 0;
        }

        default void damaged() {}

        /** Called when a frame of version 1 goes out. */
        default void sendsVersion1(long now) {}
    }

    private static final int BUFFER = 1024;
    /** The most messages that are kept. Older messages are dropped, since nobody may take a board's messages. */
    static final int MAX_MESSAGES = 64;
    /** The most reads in a row: enough to empty any driver. The limit ends the reads on a line that is never silent. */
    private static final int READS = 64;

    private final Monitor monitor;
    private final Deque<Reply> messages = new ArrayDeque<>();
    private final byte[] buffer = new byte[BUFFER]; // used only by the thread that reads
    private final Transport transport;
    private final LineClock clock;
    private final FrameDecoder version1;
    private final WireDecoder version2;
    private final LocalEchoFilter localEchoes = new LocalEchoFilter();
    private final StrayBytes.Gatherer stray = new StrayBytes.Gatherer();
    private final BoardStatus board;
    private final Listener listener;
    private boolean isBeingRead;
    private volatile long lastByteNanos;

    Inbox(Monitor monitor, Transport transport, LineClock clock, BoardStatus board, Listener listener) {
        this.monitor = monitor;
        this.transport = transport;
        this.clock = clock;
        this.board = board;
        this.listener = listener;
        long timeout = FrameDecoder.interByteTimeoutNanos(transport.line());
        version1 = new FrameDecoder(timeout, this::keep);
        version2 = new WireDecoder(true, timeout, listener::nonce, this::handOn);
        lastByteNanos = clock.nanos();
    }

    /**
     * Returns the next message of version 1. Returns null if none is complete by {@code deadlineNanos}, or if the board speaks version 2.
     */
    Reply next(long deadlineNanos) throws PortException {
        return monitor.get(() -> {
            while (true) {
                long left = nanosToWait(deadlineNanos);
                if (left == 0 && isBeingRead || !messages.isEmpty()) {
                    return messages.poll();
                }
                if (isBeingRead) {
                    monitor.await(() -> isBeingRead && messages.isEmpty() ? nanosToWait(deadlineNanos) : 0);
                } else {
                    readFor(left);
                    if (left == 0) {
                        return messages.poll();
                    }
                }
            }
        });
    }

    private long nanosToWait(long deadlineNanos) {
        return board.speaks2() ? 0 : Math.max(0, deadlineNanos - clock.nanos());
    }

    boolean hasMessage() {
        return monitor.get(() -> !messages.isEmpty());
    }

    /** Reads the bytes that have arrived, and keeps them. */
    void look() throws PortException {
        readReady(1);
    }

    /** Reads the bytes that have arrived. Returns the newest message and forgets the others. Returns null if there is none. */
    Reply newest() throws PortException {
        readReady(READS);
        return monitor.get(() -> {
            Reply newest = messages.peekLast();
            messages.clear();
            return newest;
        });
    }

    /** Reads the bytes that have arrived, and forgets all messages, even unfinished ones. */
    void clear() throws PortException {
        readReady(READS);
        monitor.change(() -> {
            messages.clear();
            version1.reset();
        });
    }

    /** Reads the bytes that have arrived, with at most {@code most} reads. Does nothing if another thread reads. */
    private void readReady(int most) throws PortException {
        monitor.get(() -> {
            for (int reads = 0; reads < most && !isBeingRead && readFor(0) > 0; reads++) {}
            return null;
        });
    }

    /** Records that a frame of version 1 is about to go out. An echo of the frame then does not count as a message. */
    void sends(Frame frame) {
        monitor.change(() -> {
            localEchoes.sends(frame);
            listener.sendsVersion1(clock.nanos());
        });
    }

    /** Returns the bytes since the last message of either version. */
    StrayBytes strayBytes() {
        return monitor.get(() -> stray.soFar(transport.line().baud()));
    }

    long lastByteNanos() {
        return lastByteNanos;
    }

    /** Returns the number of frames of version 2 with a wrong checksum. */
    long corrupt() {
        return monitor.get(version2::corrupt);
    }

    /** Returns whether any thread reads. The caller holds the monitor's lock. */
    boolean isBeingRead() {
        return isBeingRead;
    }

    /**
     * Reads for at most {@code nanos}. Stops earlier if an unfinished frame must be given up. The caller holds the monitor's lock exactly
     * once. The lock is released during the read. Call this only if no thread {@link #isBeingRead reads}.
     */
    int readFor(long nanos) throws PortException {
        long start = clock.nanos();
        long idle = Math.min(version1.nanosUntilIdle(start), version2.nanosUntilIdle(start));
        long wait = TimeUnit.NANOSECONDS.toMillis(Math.min(nanos, idle) + TimeUnit.MILLISECONDS.toNanos(1) - 1);
        int millis = (int) Math.min(wait, Integer.MAX_VALUE);
        int count = 0;
        isBeingRead = true;
        try {
            count = monitor.unlocked(() -> transport.read(buffer, 0, BUFFER, millis));
        } finally {
            isBeingRead = false;
        }
        long now = clock.nanos();
        if (count > 0) {
            accept(count, now);
        } else { // bytes may have come after the time limit, so only the limit itself was silent
            long silent = Math.min(now, start + TimeUnit.MILLISECONDS.toNanos(millis));
            version1.idle(silent);
            version2.idle(silent);
        }
        return count;
    }

    private void accept(int count, long now) {
        lastByteNanos = now;
        stray.add(buffer, count);
        long corrupt = version2.corrupt();
        listener.receiving(count, now);
        if (board.maySpeak2()) {
            version2.acceptUnbroken(buffer, 0, count, now);
        }
        if (!board.speaks2()) {
            version1.acceptUnbroken(buffer, 0, count, now);
        }
        if (version2.corrupt() > corrupt) {
            listener.damaged();
        }
    }

    private void handOn(WireFrame frame) {
        stray.clear();
        listener.received(frame, lastByteNanos);
    }

    private void keep(Frame frame) {
        stray.clear();
        if (localEchoes.isEcho(frame)) {
            return;
        }
        if (messages.size() == MAX_MESSAGES) {
            messages.poll();
        }
        messages.add(new Reply(frame.text(), Protocol.V1, lastByteNanos));
    }
}
