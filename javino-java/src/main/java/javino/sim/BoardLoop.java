package javino.sim;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import javino.Frame;
import javino.FrameDecoder;
import javino.LineClock;
import javino.PortException;
import javino.PortGoneException;
import javino.Protocol;
import javino.Transport;

/**
 * What all boards' programs have in common: takes messages from a line, one after the other, and answers each in its version of the
 * protocol. In version 2 an action that is repeated is acknowledged again, but not returned again.
 *
 * <p>One loop serves one opening of the port. Its thread calls all methods; {@link #write} and {@link #bytesOf} are safe on any thread.
 */
public final class BoardLoop {
    private static final int WRITE_MILLIS = 10_000;

    private final Transport line;
    private final LineClock clock;
    private final Lock writing; // a test sends on its own thread
    private final Condition never; // of the same lock
    private final FrameDecoder decoder;
    private final Deque<Frame> arrived = new ArrayDeque<>();
    private final byte[] buffer = new byte[MemoryLine.CAPACITY];
    private volatile int version = 1; // of the message taken last
    private int sequence; // guarded by this
    private Frame acted; // the last action that wanted to be acknowledged; null: there was none
    private int actedWith; // the outcome's flag
    private long read; // bytes
    private volatile long handled; // bytes, all messages of which have been handled
    private volatile int silences;

    /**
     * @param line the board's end
     * @param reads the version whose messages are found, or both
     * @param clock the line's
     */
    public BoardLoop(Transport line, Protocol reads, LineClock clock) {
        this.line = line;
        this.clock = clock;
        writing = clock.newLock(false);
        never = writing.newCondition();
        decoder = new FrameDecoder(FrameDecoder.interByteTimeoutNanos(line.line()), reads, arrived::add);
    }

    /**
     * Takes the next message, waiting for one at most {@code timeoutMillis}.
     *
     * @return null if none has arrived, or only an action that had been handled before
     * @throws javino.PortGoneException if the line is gone
     * @throws InterruptedException if the thread is interrupted
     */
    public Frame next(int timeoutMillis) throws PortException, InterruptedException {
        receive(timeoutMillis);
        return take();
    }

    /** Waits for bytes unless a message is there, and takes all that have arrived by then. */
    void receive(int timeoutMillis) throws PortException {
        boolean waits = arrived.isEmpty();
        int count = 0;
        try {
            count = line.read(buffer, 0, buffer.length, waits ? timeoutMillis : 0);
        } catch (PortGoneException e) {
            if (waits) { // else what arrived before comes first
                throw e;
            }
        }
        if (count > 0) {
            read += count;
            decoder.acceptUnbroken(buffer, 0, count, clock.nanos());
        } else if (waits && timeoutMillis > 0) {
            silences++;
        }
        decoder.idle(clock.nanos());
        markHandled();
    }

    /** Takes a message that has arrived; null if there is none, or only an action that had been handled before. */
    Frame take() throws PortException, InterruptedException {
        Frame frame = arrived.poll();
        if (frame != null) {
            version = frame.version();
            if (frame.has(Frame.ACK_WANTED) && frame.equals(acted)) {
                sendOutcome(frame);
                return null;
            }
        }
        return frame;
    }

    /** The number of messages that have arrived and were not taken. */
    int waiting() {
        return arrived.size();
    }

    /** Removes the oldest message that was not taken, and returns it. */
    Frame overwrite() {
        return arrived.remove();
    }

    /** Reads the bytes that have arrived, and ignores them. */
    void ignore() throws PortException {
        read += line.read(buffer, 0, buffer.length, 0);
    }

    /** Notes that the message taken last has been handled, as far as others can see. */
    void markHandled() {
        if (arrived.isEmpty() && decoder.nanosUntilIdle(clock.nanos()) == Long.MAX_VALUE) {
            handled = read;
        }
    }

    /** How many times the line has been silent while this waited for a byte; safe on any thread. */
    int silences() {
        return silences;
    }

    /**
     * Whether everything that was written to the board has been read and handled; safe on any thread.
     *
     * @param silencesBefore {@link #silences} at an earlier time: on a line that cannot be seen to be empty, two more have to follow
     */
    boolean isDrained(int silencesBefore) {
        return line instanceof MemoryLine.End end ? end.isRead(handled) : silences - silencesBefore >= 2;
    }

    /** The version of the protocol of the message that was taken last; 1 before the first. */
    public int version() {
        return version;
    }

    /**
     * The bytes of a message in {@link #version}; in version 2 it may have any length.
     *
     * @throws IllegalArgumentException if the text does not fit into a message
     */
    public synchronized byte[] bytesOf(String text) {
        if (version == 1) {
            return Frame.of(text).toBytes();
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        List<Frame> fragments =
                Frame.fragments(Frame.requireBytes(text).getBytes(StandardCharsets.ISO_8859_1), sequence);
        sequence = (sequence + fragments.size()) % Frame.SEQUENCES;
        fragments.forEach(fragment -> bytes.writeBytes(fragment.toBytes()));
        return bytes.toByteArray();
    }

    /** Sends a message, and returns when its last byte has left; as {@link #bytesOf} and {@link #send}. */
    public void say(String text) throws PortException, InterruptedException {
        send(bytesOf(text));
    }

    /**
     * Writes bytes, and returns when the last has left: a board does not read while it sends. If the port has been closed they are lost, as
     * on a device; {@link #next} throws as soon as all that was received has been taken.
     */
    public void send(byte... bytes) throws PortException, InterruptedException {
        try {
            write(bytes);
        } catch (PortGoneException e) {
            return;
        }
        pause(bytes.length * line.line().byteNanos());
    }

    /** Writes bytes, and returns when the line has taken them. */
    public void write(byte... bytes) throws PortException {
        writing.lock();
        try {
            line.write(bytes, 0, bytes.length, WRITE_MILLIS);
        } finally {
            writing.unlock();
        }
    }

    /** Reports that an action has been carried out; sends nothing if the message does not ask for that. */
    public void acknowledge(Frame message) throws PortException, InterruptedException {
        finish(message, Frame.ACK);
    }

    /** Reports that an action is unknown; sends nothing if the message does not ask for that. */
    public void refuse(Frame message) throws PortException, InterruptedException {
        finish(message, Frame.REFUSAL);
    }

    private void finish(Frame message, int outcome) throws PortException, InterruptedException {
        if (message.has(Frame.ACK_WANTED)) {
            acted = message;
            actedWith = outcome;
            sendOutcome(message);
        }
    }

    private void sendOutcome(Frame action) throws PortException, InterruptedException {
        send(Frame.version2(new byte[0], actedWith, action.sequence()).toBytes());
    }

    /** Does nothing for {@code nanos} of the line's clock. */
    public void pause(long nanos) throws InterruptedException {
        writing.lockInterruptibly();
        try {
            clock.await(never, nanos);
        } finally {
            writing.unlock();
        }
    }
}
