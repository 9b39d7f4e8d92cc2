package javino.sim;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import javino.BoardReceiver;
import javino.Frame;
import javino.FrameDecoder;
import javino.LineClock;
import javino.PerceptsRequest;
import javino.PortException;
import javino.PortGoneException;
import javino.Protocol;
import javino.Transport;
import javino.wire.FrameKind;
import javino.wire.WireFrame;

/**
 * Runs a board's program: reads messages from a line, lets the program handle them one by one, and answers each in its protocol version.
 * <p>A loop serves one opening of the port. Only the board's thread calls the methods. Exception: {@link #say} and {@link #write} are
 * safe on any thread.
 */
public final class BoardLoop {
    private static final System.Logger LOG = System.getLogger(BoardLoop.class.getName());
    private static final int WRITE_MILLIS = 10_000;
    private static final int READ_MILLIS = 100;
    private static final int LOOK_MILLIS = 5;

    private final Transport line;
    private final BoardProgram program;
    private final LineClock clock;
    private final Lock writing; // tests send on other threads
    private final Condition never; // condition of the lock writing; never signalled
    private final BoardReceiver receiver;
    private final BoardSession session;
    private final Deque<BoardReceiver.Found> arrived = new ArrayDeque<>();
    private final byte[] buffer = new byte[MemoryLine.CAPACITY];
    private volatile Thread board;
    private volatile int version = 1; // protocol version of the last handled message
    // the receiver's clock: the sum of all silences. Bytes that waited for this thread therefore do not count as late
    private long silentNanos;
    private long listenedNanos; // silence since the last byte
    private long lookedNanos;
    private boolean isLooking;
    private boolean hasToldLeftOut;
    private boolean isHandlingCommands; // further commands of the frame may follow
    private boolean isAnswering;
    private int requestBytes;
    private int answerBytes;
    private long read; // number of bytes read
    private volatile long handled; // value of read when the last message was handled
    private volatile int silences;

    /** Creates a loop that reads both versions and watches no rules. */
    public BoardLoop(Transport line, BoardProgram program, LineClock clock) {
        this(line, program, Protocol.AUTO, BoardSession.Capacity.FULL, clock);
    }

    /**
     * @param line the board's end of the line, whose waits use {@code clock}
     * @param reads the version whose messages are read, or both
     * @param capacity the capacity that the board reports to computers of version 2
     */
    public BoardLoop(
            Transport line, BoardProgram program, Protocol reads, BoardSession.Capacity capacity, LineClock clock) {
        this.line = line;
        this.program = program;
        this.clock = clock;
        writing = clock.newLock(false);
        never = writing.newCondition();
        session = new BoardSession(program, capacity, this::sendFrame);
        receiver = new BoardReceiver(
                reads,
                FrameDecoder.interByteTimeoutNanos(line.line()),
                capacity.longestPayload(),
                this::nonce,
                arrived::add);
    }

    /** Returns the nonce for checking new bytes, or 0. If an unhandled message begins a session, this is the nonce of that session. */
    private int nonce() {
        Iterator<BoardReceiver.Found> newestFirst = arrived.descendingIterator();
        while (newestFirst.hasNext()) {
            OptionalInt nonce = newestFirst.next().nonceBehind();
            if (nonce.isPresent()) {
                return nonce.getAsInt();
            }
        }
        return session.nonce();
    }

    /** Handles messages until the line is gone. Then throws {@link javino.PortGoneException}. */
    public void run() throws PortException, InterruptedException {
        while (true) {
            step(READ_MILLIS);
        }
    }

    /** Handles the next message. Waits for the message at most {@code timeoutMillis}, or a few milliseconds if the board watches rules. */
    public void step(int timeoutMillis) throws PortException, InterruptedException {
        receive(timeoutMillis);
        handleNext();
    }

    /** Waits for bytes, unless a message waits already. Then takes all bytes that have arrived. */
    void receive(int timeoutMillis) throws PortException {
        board = Thread.currentThread();
        boolean waits = arrived.isEmpty();
        int count = 0;
        long start = clock.nanos();
        try {
            count = line.read(buffer, 0, buffer.length, waits ? patience(timeoutMillis) : 0);
        } catch (PortGoneException e) {
            if (waits) { // else the waiting message is handled first
                throw e;
            }
        }
        listenedNanos += clock.nanos() - start;
        for (int i = 0; i < count; i++) {
            receiver.accept(buffer[i], silentNanos, listenedNanos);
            listenedNanos = 0;
        }
        read += count;
        if (count == 0 && waits) {
            silentNanos += clock.nanos() - start;
            silences += timeoutMillis > 0 ? 1 : 0;
        }
        receiver.idle(silentNanos);
        markHandled();
    }

    private int patience(int timeoutMillis) {
        return session.hasRules() ? Math.min(timeoutMillis, LOOK_MILLIS) : timeoutMillis;
    }

    /** Handles a waiting message, if there is one. Then compares the percepts with the rules. */
    void handleNext() throws PortException, InterruptedException {
        BoardReceiver.Found found = arrived.poll();
        if (found != null && found.version2() != null) {
            handle(found.version2());
        } else if (found != null) {
            handle(found.version1());
        }
        markHandled();
        look();
    }

    private void handle(WireFrame frame) throws PortException, InterruptedException {
        version = 2;
        requestBytes = frame.toBytes(session.nonce()).length;
        answerBytes = 0;
        isAnswering = frame.kind() == FrameKind.ASK;
        isHandlingCommands = frame.kind() == FrameKind.COMMANDS || frame.kind() == FrameKind.COMMANDS_WITH_RESUME;
        try {
            session.receive(frame);
        } finally {
            isHandlingCommands = false;
        }
    }

    private void handle(Frame frame) throws PortException, InterruptedException {
        version = 1;
        session.end();
        if (!PerceptsRequest.isIn(frame.text())) {
            program.carryOut(frame.text());
            return;
        }
        String answer = program.percepts(frame.text());
        if (answer != null) {
            byte[] bytes = Frame.of(answer).toBytes();
            put(bytes);
            program.answered(frame.length(), bytes.length, endNanos(bytes));
            pauseFor(bytes);
        }
    }

    private void look() throws PortException, InterruptedException {
        if (isLooking
                || !session.hasRules()
                || clock.nanos() - lookedNanos < TimeUnit.MILLISECONDS.toNanos(LOOK_MILLIS)) {
            return;
        }
        isLooking = true; // frames that this call sends must not cause another look
        try {
            String percepts = program.sensors();
            session.look(percepts == null ? "" : percepts);
            lookedNanos = clock.nanos();
        } finally {
            isLooking = false;
        }
    }

    int waiting() {
        return arrived.size();
    }

    /** Removes and returns the oldest unhandled message. Returns empty for a message of version 2, which the computer repeats. */
    Optional<Frame> overwrite() {
        return Optional.ofNullable(arrived.remove().version1());
    }

    void ignore() throws PortException {
        read += line.read(buffer, 0, buffer.length, 0);
    }

    /** Records for {@link #isDrained} that the present message is handled. */
    void markHandled() {
        if (arrived.isEmpty() && !isHandlingCommands && receiver.nanosUntilIdle(silentNanos) == Long.MAX_VALUE) {
            handled = read;
        }
    }

    BoardSession session() {
        return session;
    }

    /** Returns the number of waits in which no byte came. Safe on any thread. */
    int silences() {
        return silences;
    }

    /**
     * Returns whether the board has read and handled all bytes. Safe on any thread.
     * @param silencesBefore an earlier value of {@link #silences}; two more silences show that a line outside of memory is empty
     */
    boolean isDrained(int silencesBefore) {
        return line instanceof MemoryLine.End end ? end.isRead(handled) : silences - silencesBefore >= 2;
    }

    /** Returns the protocol version of the last handled message, or 1 before the first message. */
    public int version() {
        return version;
    }

    /**
     * Sends a message unasked, in {@link #version}. In version 2 the message may have any length. On the board's thread, returns when the
     * last byte has left.
     *
     * @throws IllegalArgumentException if the text does not fit into a message
     */
    public void say(String text) throws PortException, InterruptedException {
        if (version == 2) {
            session.sendPercepts(Frame.requireBytes(text));
        } else {
            send(Frame.of(text).toBytes());
        }
    }

    /** Splits a text into messages of {@link #version}. Sends all messages except the last, and returns the last. */
    String sayBeginning(String text) throws PortException, InterruptedException {
        List<String> messages = version == 1 ? MessageParts.of(text) : List.of(text);
        if (!hasToldLeftOut && messages.stream().mapToInt(String::length).sum() < text.length()) {
            hasToldLeftOut = true;
            LOG.log(
                    System.Logger.Level.WARNING,
                    "the board at port " + line.name() + " has a percept of more than " + Frame.MAX_PAYLOAD
                            + " bytes, which version 1 cannot carry; it is left out. Further ones are left out without a warning");
        }
        for (String message : messages.subList(0, messages.size() - 1)) {
            say(message);
        }
        return messages.get(messages.size() - 1);
    }

    /** Sends a frame of the session on the calling thread. */
    private void sendFrame(WireFrame frame, int nonce) throws PortException, InterruptedException {
        byte[] bytes = frame.toBytes(nonce);
        put(bytes);
        if (Thread.currentThread() != board) {
            return;
        }
        if (isAnswering && isPercepts(frame.kind())) {
            answerBytes += bytes.length;
            if (frame.kind() != FrameKind.PERCEPTS_PART) {
                program.answered(requestBytes, answerBytes, endNanos(bytes));
            }
        }
        pauseFor(bytes);
        look();
    }

    private static boolean isPercepts(FrameKind kind) {
        return kind == FrameKind.PERCEPTS || kind == FrameKind.PERCEPTS_PART || kind == FrameKind.PERCEPTS_LAST;
    }

    /**
     * Writes bytes. On the board's thread, returns when the last byte has left, because a board does not read while it sends. If the port
     * is closed, the bytes are lost. {@link #step} then throws after all received messages are handled.
     */
    public void send(byte... bytes) throws PortException, InterruptedException {
        put(bytes);
        if (Thread.currentThread() == board) {
            pauseFor(bytes);
        }
    }

    private void put(byte... bytes) throws PortException {
        try {
            write(bytes);
        } catch (PortGoneException e) {
            if (Thread.currentThread() != board) {
                throw e;
            }
        }
    }

    private void pauseFor(byte... bytes) throws InterruptedException {
        pause(bytes.length * line.line().byteNanos());
    }

    private long endNanos(byte... bytes) {
        return clock.nanos() + bytes.length * line.line().byteNanos();
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
