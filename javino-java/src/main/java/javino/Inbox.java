package javino;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;

/**
 * Reads a line and keeps what came until it is asked for: messages, and what the board says of an action.
 *
 * <p>Leader and followers: one of the waiting threads reads, keeps what is for the others, and hands the reading on when its own wait
 * ends. One thread at a time waits for messages, and one for the outcome of an action.
 */
final class Inbox {
    /** Told whenever bytes have arrived. */
    interface ReadListener {
        /** Records that {@code bytes} have been read at {@code now}, in nanoseconds of the line's clock. */
        void received(int bytes, long now);
    }

    /** What a board says of an action. */
    enum Outcome {
        DONE,
        REFUSED
    }

    private static final int BUFFER = 1024;
    /** Messages that wait at most to be taken: nobody may ever take one of a board that speaks unasked. The newest count. */
    private static final int MAX_MESSAGES = 64;

    private static final System.Logger LOG = System.getLogger(Inbox.class.getName());
    /** Reads at most, one after the other, of what a line has ready: more than any driver holds, but an end for a line that never rests. */
    private static final int READS = 64;

    private final Monitor monitor;
    private final Deque<Reply> messages = new ArrayDeque<>();
    private final byte[] buffer = new byte[BUFFER]; // belongs to who reads
    private final Transport transport;
    private final LineClock clock;
    private final FrameDecoder decoder;
    private final Reassembler reassembler;
    private final LocalEchoFilter localEchoes = new LocalEchoFilter();
    private final ReadListener received;
    private final long interByteTimeoutNanos;
    private boolean beingRead;
    private boolean version2; // and nothing else
    private int awaited; // the action whose outcome is waited for
    private Outcome outcome;
    private boolean toldOfLength;
    private long wasted; // bytes that had made no frame by the last one that did, or a silence behind them
    private volatile long lastByteNanos;

    /**
     * An inbox for version 1.
     *
     * @param received told whenever bytes have arrived
     */
    Inbox(Transport transport, LineClock clock, ReadListener received) {
        this(transport, clock, received, Protocol.V1, Frame.MAX_PAYLOAD);
    }

    /**
     * @param received told whenever bytes have arrived
     * @param messageLimit bytes that a message of several fragments has at most
     */
    Inbox(Transport transport, LineClock clock, ReadListener received, Protocol protocol, int messageLimit) {
        this.transport = transport;
        this.clock = clock;
        monitor = new Monitor(clock, transport.name());
        this.received = received;
        interByteTimeoutNanos = FrameDecoder.interByteTimeoutNanos(transport.line());
        decoder = new FrameDecoder(interByteTimeoutNanos, protocol, this::keep);
        reassembler = new Reassembler(messageLimit);
        version2 = protocol == Protocol.V2;
        lastByteNanos = clock.nanos();
    }

    /** Reads this version alone from now on. */
    void read(Protocol protocol) {
        monitor.change(() -> {
            version2 = protocol == Protocol.V2;
            decoder.read(protocol);
        });
    }

    /** The next message, or null if none is complete when the clock shows {@code deadlineNanos}; one that has passed does not wait. */
    Reply next(long deadlineNanos) throws PortException {
        return await(messages::poll, deadlineNanos);
    }

    /** Forgets the outcomes of earlier actions, since action {@code sequence} is about to go out. */
    void expectOutcome(int sequence) {
        monitor.change(() -> {
            awaited = sequence;
            outcome = null;
        });
    }

    /** The outcome of the action that is expected, or null if it is not known when the clock shows {@code deadlineNanos}. */
    Outcome outcome(long deadlineNanos) throws PortException {
        return await(() -> outcome, deadlineNanos);
    }

    /** Reads what the line has ready, and keeps it. */
    void look() throws PortException {
        readReady(1);
    }

    /** Reads what the line has ready, and returns the newest message among that and what was read before, or null. */
    Reply newest() throws PortException {
        readReady(READS);
        return monitor.get(() -> {
            Reply newest = messages.peekLast();
            messages.clear();
            return newest;
        });
    }

    /** Reads what the line has ready, and forgets all messages with that and what was read before, unfinished ones too. */
    void clear() throws PortException {
        readReady(READS);
        monitor.change(() -> {
            messages.clear();
            if (!version2) {
                decoder.reset(); // in version 2 what is unfinished may be the outcome of an action
            }
            reassembler.asked();
            wasted = decoder.discarded();
        });
    }

    /** Reads what the line has ready, in at most {@code most} pieces, unless another thread reads. */
    private void readReady(int most) throws PortException {
        monitor.get(() -> {
            for (int reads = 0; reads < most && !beingRead && readFor(0) > 0; reads++) {}
            return null;
        });
    }

    /** Records that a request is about to go out for whose sake nothing is forgotten. */
    void asked() {
        monitor.change(reassembler::asked);
    }

    /** Records that a frame is about to go out, which is no message if the line brings it back. */
    void sends(Frame frame) {
        monitor.change(() -> localEchoes.sends(frame));
    }

    /** When the last byte arrived. */
    long lastByteNanos() {
        return lastByteNanos;
    }

    /** Bytes so far that made no frame. */
    long discardedBytes() {
        return monitor.get(decoder::discarded);
    }

    /** Frames so far whose checksum was wrong. */
    long corrupt() {
        return monitor.get(decoder::corrupt);
    }

    private <T> T await(Supplier<T> wanted, long deadlineNanos) throws PortException {
        return monitor.get(() -> {
            for (T found = wanted.get(); true; found = wanted.get()) {
                long now = clock.nanos();
                long left = Math.max(0, deadlineNanos - now);
                if (found != null || left == 0 && beingRead) {
                    return found;
                }
                if (beingRead) {
                    monitor.await(left);
                } else {
                    readFor(Math.min(left, decoder.nanosUntilIdle(now)));
                    if (left == 0) {
                        return wanted.get();
                    }
                }
            }
        });
    }

    /** Reads for at most {@code nanos}, during which the lock is free: the caller holds it once. */
    private int readFor(long nanos) throws PortException {
        long millis = TimeUnit.NANOSECONDS.toMillis(nanos + TimeUnit.MILLISECONDS.toNanos(1) - 1);
        int count = 0;
        beingRead = true;
        try {
            count = monitor.unlocked(
                    () -> transport.read(buffer, 0, BUFFER, (int) Math.min(millis, Integer.MAX_VALUE)));
        } finally {
            beingRead = false;
        }
        long now = clock.nanos();
        if (count > 0) {
            lastByteNanos = now;
            // a read that finds nothing shows a silence, a late one does not
            decoder.acceptUnbroken(buffer, 0, count, now);
            received.received(count, now);
        } else {
            decoder.idle(now);
            noteSilence(now);
        }
        return count;
    }

    private void noteSilence(long now) {
        if (decoder.discarded() > wasted && now - lastByteNanos > interByteTimeoutNanos) {
            wasted = decoder.discarded();
            reassembler.excuse();
        }
    }

    private void keep(Frame frame) {
        if (localEchoes.isEcho(frame)) {
            return;
        }
        if (frame.version() == 1) {
            keep(new Reply(frame.text(), Protocol.V1, lastByteNanos));
        } else if (frame.has(Frame.ACK | Frame.REFUSAL)) {
            keepOutcome(frame);
        } else {
            String message = reassembler.accept(frame, decoder.discarded() > wasted);
            wasted = decoder.discarded();
            if (message != null) {
                keep(new Reply(message, Protocol.V2, lastByteNanos));
            }
            tellOfLength();
        }
    }

    private void keep(Reply message) {
        if (messages.size() == MAX_MESSAGES) {
            messages.poll();
        }
        messages.add(message);
    }

    /** Says so when a message was too long; and not again before one has come that was not. */
    private void tellOfLength() {
        if (reassembler.tooLong() != toldOfLength) {
            toldOfLength = reassembler.tooLong();
            if (toldOfLength) {
                LOG.log(
                        System.Logger.Level.WARNING,
                        "port " + transport.name() + " sent a message of more than " + reassembler.limit()
                                + " bytes, which is dropped; longer ones are dropped without a word until one comes that is not");
            }
        }
    }

    private void keepOutcome(Frame frame) {
        if (frame.sequence() == awaited && outcome == null) {
            outcome = frame.has(Frame.REFUSAL) ? Outcome.REFUSED : Outcome.DONE;
        }
    }
}
