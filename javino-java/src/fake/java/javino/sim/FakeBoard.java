package javino.sim;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javino.LineClock;
import javino.PerceptKind;
import javino.PerceptsRequest;
import javino.PortException;
import javino.Protocol;
import javino.wire.BoardAction;
import javino.wire.WireFrame;

/**
 * A board for tests. Programs reach the board at the port {@code sim:name}. The board answers by the test's rules, and records the
 * messages that it receives:
 *
 * <pre>{@code
 * try (FakeBoard board = FakeBoard.plugIn("robot")) {
 *     board.whenAsked("getPercepts").answer("dist(f,10);");
 *     startTheAgent(); // whose port is sim:robot
 *     board.awaitMessage("stop", 10_000);
 * }
 * }</pre>
 *
 * <p>By default the board is strict: {@link #verify} and {@link #close} fail if an {@linkplain #expect expected} message is missing. They
 * also fail if a message was lost (see {@link #queueSize}), or if a surprising message came. No rule covers a surprising message, and the
 * test neither expects it nor takes it with {@code awaitMessage}. A {@linkplain #lenient lenient} board accepts missing, lost and
 * surprising messages.
 *
 * <p>By default the board starts at once, queues any number of messages, and answers {@code getPercepts} with an empty message. The line
 * has the baud rate with which the port is opened. All methods are safe on any thread. Rules may change while the board runs.
 */
public final class FakeBoard implements AutoCloseable {
    private static final int MAX_DRAIN_MILLIS = 10_000;

    private final String name;
    private final FakeBoardScript script = new FakeBoardScript();
    private final FakeBoardRecord record;
    private final FakeBoardSketch sketch;
    private volatile boolean strict = true;

    private FakeBoard(String name, LineClock clock) {
        this.name = name;
        FakeBoardMonitor monitor = new FakeBoardMonitor(clock);
        record = new FakeBoardRecord(port(), monitor, clock);
        sketch = new FakeBoardSketch(port(), script, record, monitor, clock);
        whenAsked(PerceptsRequest.ALL).answer("");
    }

    /**
     * Creates a board and plugs it in at the port {@code sim:name}.
     *
     * @throws IllegalStateException if another board with this name is plugged in
     */
    public static FakeBoard plugIn(String name) {
        FakeBoard board = new FakeBoard(name, LineClock.system());
        SimulatedBoards.plugIn(name, board.sketch);
        return board;
    }

    /**
     * Creates a board that is not plugged in. The caller runs the board's {@link #program} on a line that uses {@code clock}.
     *
     * @param name the board's name in messages
     */
    public static FakeBoard unplugged(String name, LineClock clock) {
        return new FakeBoard(name, clock);
    }

    /** The port to open: {@code sim:name}. */
    public String port() {
        return SimulatedBoards.SCHEME + ':' + name;
    }

    /** Returns the board's program. A test can run the program on another line, such as a pseudo-terminal. */
    public SimulatedBoard program() {
        return sketch;
    }

    /** Sets how the board handles a message. Replaces an earlier rule for the message. */
    public Rule whenAsked(String message) {
        return script.rule(message, message::equals);
    }

    /**
     * Sets how the board handles messages of a kind. A rule for one message takes precedence over rules for kinds. If several rules for
     * kinds cover a message, the earliest rule applies.
     */
    public Rule whenAsked(Predicate<String> kind) {
        return script.rule(null, kind);
    }

    /** Expects a message once. A test that expects a message twice calls this twice. */
    public FakeBoard expect(String message) {
        record.expect(message);
        return this;
    }

    /** Makes the board accept unexpected messages and the absence of expected messages. */
    public FakeBoard lenient() {
        strict = false;
        return this;
    }

    /**
     * Sets how many received messages a busy board holds. A further message overwrites the oldest, see {@link #overwritten}. Real version
     * 1 boards hold one message. Frames of version 2 never count as overwritten: the computer repeats them.
     */
    public FakeBoard queueSize(int messages) {
        if (messages < 1) {
            throw new IllegalArgumentException(
                    "a board holds at least 1 message, but a queue of " + messages + " was asked for");
        }
        sketch.queueSize = messages;
        return this;
    }

    /**
     * Lets the board speak version 2 with computers that speak version 2, and version 1 with others. In version 2 the board acknowledges
     * each command after handling it, and handles a repeated command only once. Answers may be longer than a frame. The board sends its
     * answer to a command as unasked percepts. Call this before the port is opened.
     */
    public FakeBoard version2() {
        sketch.protocol = Protocol.AUTO;
        return this;
    }

    /**
     * Sets the actions that the board reports to computers of version 2. By default the board reports none, and computers check no
     * command.
     * @param actions {@code ledOn}; {@code speed/1}, with one argument; {@code say/*}, with any number of arguments
     */
    public FakeBoard knows(String... actions) {
        sketch.vocabulary = Arrays.stream(actions).map(FakeBoard::action).toList();
        return this;
    }

    /**
     * Lets the board describe its percepts to computers of version 2.
     *
     * @param kinds the kinds, in the syntax of {@link PerceptKind#parse}: {@code dist(front|left, cm 0..400)}
     */
    public FakeBoard perceives(String... kinds) {
        sketch.kinds = Arrays.stream(kinds).map(PerceptKind::parse).toList();
        return this;
    }

    private static BoardAction action(String written) {
        if (!written.matches("[^/]+(/([0-9]{1,2}|\\*))?")) {
            throw new IllegalArgumentException(
                    "an action is written NAME, NAME/ARGUMENTS or NAME/*, not \"" + written + '"');
        }
        String[] parts = written.split("/");
        String arguments = parts.length == 1 ? "0" : parts[1];
        return new BoardAction(parts[0], arguments.equals("*") ? BoardAction.ANY : Integer.parseInt(arguments));
    }

    /**
     * Lets the board of version 2 watch at most {@code rules} critical rules; 0 by default. The board compares the rules with its answer
     * to {@code getPercepts}, once per {@linkplain #loopTakes loop} and at most every 5 ms. The board handles and records a reflex like a
     * received command. Call this before the port is opened.
     */
    public FakeBoard holdsRules(int rules) {
        sketch.rules = rules;
        return this;
    }

    /** Sets how many milliseconds the board is busy with other work between two messages. */
    public FakeBoard loopTakes(int millis) {
        sketch.loopMillis = millis;
        return this;
    }

    /** Sets how many milliseconds the board takes to start when its port is opened. The board loses bytes that arrive while it starts. */
    public FakeBoard bootTakes(int millis) {
        sketch.bootMillis = millis;
        return this;
    }

    /** Stops the board from reading. Bytes wait on the line until {@link #resume}. */
    public void stall() {
        sketch.stall(true);
    }

    /** Lets the board read again after {@link #stall}. */
    public void resume() {
        sketch.stall(false);
    }

    /**
     * Sends a message unasked. Uses the protocol version of the last message that the board received.
     *
     * @throws IllegalStateException if nobody has the port open
     */
    public void send(String message) throws PortException {
        sketch.send(message);
    }

    /**
     * Writes bytes to the line unchanged, such as noise or half a frame.
     *
     * @throws IllegalStateException if nobody has the port open
     */
    public void noise(byte... bytes) throws PortException {
        sketch.write(bytes);
    }

    /**
     * Writes a frame of version 2 to the line, in the current session.
     *
     * @throws IllegalStateException if nobody has the port open
     */
    public void noise(WireFrame frame) throws PortException {
        sketch.write(frame);
    }

    /** Unplugs the board. The port is gone for its owner, and cannot be opened. */
    public void unplug() {
        SimulatedBoards.unplug(name);
    }

    /**
     * Plugs the board in again.
     *
     * @throws IllegalStateException if another board with this name is plugged in
     */
    public void replug() {
        SimulatedBoards.plugIn(name, sketch);
    }

    /** Waits until a program has the port open. Fails after {@code timeoutMillis}. */
    public void awaitOpen(int timeoutMillis) {
        sketch.awaitOpen(timeoutMillis);
    }

    public List<String> received() {
        return record.received();
    }

    /** Returns the messages that the board has handled so far, each with its time. */
    public List<ReceivedMessage> receivedMessages() {
        return record.receivedMessages();
    }

    /** Returns the messages that later messages overwrote before the board handled them. */
    public List<String> overwritten() {
        return record.overwritten();
    }

    /**
     * Takes the next message that no rule covers. If no such message has come, waits for one.
     *
     * @param timeoutMillis milliseconds to wait at most
     * @throws AssertionError if no message came that no rule covers; the error lists all messages that came
     */
    public String awaitMessage(int timeoutMillis) {
        return record.take(message -> true, "a message", timeoutMillis);
    }

    /** Like {@link #awaitMessage(int)}, but takes only {@code message}. Other messages stay. */
    public void awaitMessage(String message, int timeoutMillis) {
        record.take(message::equals, '"' + message + '"', timeoutMillis);
    }

    /**
     * Waits at most {@value #MAX_DRAIN_MILLIS} ms until the board has received all bytes sent to it. Does not wait for a
     * {@linkplain #stall stalled} board. Then fails if a message was surprising, missing or lost. Does nothing if the board is
     * {@linkplain #lenient lenient}.
     *
     * @throws AssertionError with the faults and all messages received
     */
    public void verify() {
        if (strict) {
            sketch.awaitDrained(() -> SimulatedBoards.isRunning(name), MAX_DRAIN_MILLIS);
            record.verify();
        }
    }

    /** Calls {@link #verify}, and unplugs the board. */
    @Override
    public void close() {
        try {
            verify();
        } finally {
            unplug();
        }
    }

    /** A rule that tells how the board handles a message. */
    public static final class Rule {
        volatile int delayMillis;
        volatile boolean refused;
        volatile int outcomeMillis; // 0: the outcome is known at once
        volatile UnaryOperator<String> answer = message -> null;
        volatile Supplier<String> sensors = () -> "";
        volatile byte[] raw; // bytes sent in place of an answer, or null

        Rule() {}

        /** Lets the board take {@code millis} milliseconds before it answers. The board does nothing else in that time. */
        public Rule after(int millis) {
            delayMillis = millis;
            return this;
        }

        /**
         * Answers with these messages in turn, then repeats the last message. If the board {@linkplain FakeBoard#holdsRules holds rules},
         * it compares them with the next answer.
         */
        public Rule answer(String first, String... next) {
            FakeBoardScript.InTurn answers = new FakeBoardScript.InTurn(first, next);
            return answer(message -> answers.next(), answers::current);
        }

        /**
         * Answers with the result of {@code answer} for the message. If the result is null, gives no answer. The board's thread calls the
         * function for each message. While the board watches rules, its thread also calls the function every few milliseconds.
         */
        public Rule answer(UnaryOperator<String> answer) {
            return answer(answer, () -> answer.apply(PerceptsRequest.ALL));
        }

        /**
         * Like {@link #answer(UnaryOperator)}.
         *
         * @param sensors returns the percepts that the board compares with its rules; called every few milliseconds
         */
        public Rule answer(UnaryOperator<String> answer, Supplier<String> sensors) {
            this.answer = answer;
            this.sensors = sensors;
            raw = null;
            return this;
        }

        /** Answers with bytes unchanged, such as a damaged frame, half a frame, or two frames. Each character is a byte (ISO-8859-1). */
        public Rule answerRaw(String bytes) {
            raw = bytes.getBytes(StandardCharsets.ISO_8859_1);
            return this;
        }

        /**
         * Lets the board of version 2 report the outcome of the command {@code millis} milliseconds after it began the command. Until the
         * report, the board answers requests but carries out no other command.
         */
        public Rule outcomeAfter(int millis) {
            outcomeMillis = millis;
            return this;
        }

        /** Gives no answer. */
        public Rule staySilent() {
            return answer(message -> null, () -> "");
        }

        /** Refuses the message like an unknown command. In version 1 the board stays silent. */
        public Rule refuse() {
            refused = true;
            return this;
        }
    }
}
