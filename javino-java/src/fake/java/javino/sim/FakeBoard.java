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
 * A board for tests. It is plugged in as {@code sim:name}, answers by the test's rules, and records its messages:
 *
 * <pre>{@code
 * try (FakeBoard board = FakeBoard.plugIn("robot")) {
 *     board.whenAsked("getPercepts").answer("dist(f,10);");
 *     startTheAgent(); // whose port is sim:robot
 *     board.awaitMessage("stop", 10_000);
 * }
 * }</pre>
 *
 * <p>The board is strict: {@link #verify} and {@link #close} fail if an {@linkplain #expect expected} message did not come, a message was
 * lost (see {@link #queueSize}), or a surprising message came. A message is surprising if no rule covers it, and the test neither expects
 * it nor takes it with {@code awaitMessage}. {@link #lenient} turns this off.
 *
 * <p>By default the board starts at once, holds any number of messages, and answers {@code getPercepts} with an empty message, like a board
 * without sensors. The line has the rate with which the port is opened. All methods are safe on any thread; rules may be changed while the
 * board runs.
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
     * A new board, plugged in as {@code sim:name}.
     *
     * @throws IllegalStateException if a board of that name is plugged in
     */
    public static FakeBoard plugIn(String name) {
        FakeBoard board = new FakeBoard(name, LineClock.system());
        SimulatedBoards.plugIn(name, board.sketch);
        return board;
    }

    /**
     * A new board that is not plugged in and uses {@code clock}. The caller runs its {@link #program} on a line of this clock.
     * @param name the board's name in messages
     */
    public static FakeBoard unplugged(String name, LineClock clock) {
        return new FakeBoard(name, clock);
    }

    /** The port to open: {@code sim:name}. */
    public String port() {
        return SimulatedBoards.SCHEME + ':' + name;
    }

    /** The board's program, for a test that runs it at the end of another line, such as a pseudo-terminal. */
    public SimulatedBoard program() {
        return sketch;
    }

    /** Sets how the board handles a message, in place of an earlier rule for the same message. */
    public Rule whenAsked(String message) {
        return script.rule(message, message::equals);
    }

    /** Sets how the board handles messages of a kind. A rule for one message precedes; of several rules for kinds the earliest applies. */
    public Rule whenAsked(Predicate<String> kind) {
        return script.rule(null, kind);
    }

    /** Expects a message once; after two calls, twice. */
    public FakeBoard expect(String message) {
        record.expect(message);
        return this;
    }

    /** Accepts that unexpected messages come, and that expected messages do not come. */
    public FakeBoard lenient() {
        strict = false;
        return this;
    }

    /**
     * Sets how many received messages a busy board holds; a further message overwrites the oldest, see {@link #overwritten}. Boards in the
     * field hold one message. Frames of version 2 never count as overwritten, since the computer repeats them.
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
     * Lets the board speak version 2 with computers that speak it, and version 1 with others. In version 2 the board acknowledges each
     * command after handling it, and handles a repeated command only once. Answers may be longer than a frame. The answer to a command goes
     * out as unasked percepts. Call this before the port is opened.
     */
    public FakeBoard version2() {
        sketch.protocol = Protocol.AUTO;
        return this;
    }

    /**
     * Gives the board a vocabulary, which it reports to computers of version 2. Without a vocabulary computers check no command.
     * @param actions {@code ledOn}; {@code speed/1}, with one argument; {@code say/*}, with any number of arguments
     */
    public FakeBoard knows(String... actions) {
        sketch.vocabulary = Arrays.stream(actions).map(FakeBoard::action).toList();
        return this;
    }

    /**
     * Lets the board describe its percepts to computers of version 2.
     *
     * @param kinds as {@link PerceptKind#parse} reads them: {@code dist(front|left, cm 0..400)}
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
     * Lets the board of version 2 watch at most {@code rules} critical rules; 0 by default. Every 5 ms, or in each round of a slower
     * {@linkplain #loopTakes loop}, the board compares the rules with its answer to {@code getPercepts}. The board handles and records a
     * reflex like a received command. Call this before the port is opened.
     */
    public FakeBoard holdsRules(int rules) {
        sketch.rules = rules;
        return this;
    }

    /** Sets how many milliseconds the board is busy with other work between two messages, like a sketch's {@code loop()}. */
    public FakeBoard loopTakes(int millis) {
        sketch.loopMillis = millis;
        return this;
    }

    /** Sets how many milliseconds the board takes to start when its port is opened; bytes that arrive in that time are lost. */
    public FakeBoard bootTakes(int millis) {
        sketch.bootMillis = millis;
        return this;
    }

    /** Stops the board from reading: bytes wait until {@link #resume}. */
    public void stall() {
        sketch.stall(true);
    }

    /** Lets the board read again after {@link #stall}. */
    public void resume() {
        sketch.stall(false);
    }

    /**
     * Sends a message unasked, in the protocol version of the last message to the board.
     *
     * @throws IllegalStateException if nobody has the port open
     */
    public void send(String message) throws PortException {
        sketch.send(message);
    }

    /**
     * Puts bytes on the line unchanged, such as noise or half a frame.
     *
     * @throws IllegalStateException if nobody has the port open
     */
    public void noise(byte... bytes) throws PortException {
        sketch.write(bytes);
    }

    /**
     * Puts a frame of version 2 on the line, in the current session: one that the board would not send by itself.
     *
     * @throws IllegalStateException if nobody has the port open
     */
    public void noise(WireFrame frame) throws PortException {
        sketch.write(frame);
    }

    /** Pulls the plug: the port is gone for its owner, and cannot be opened. */
    public void unplug() {
        SimulatedBoards.unplug(name);
    }

    /**
     * Plugs the board in again.
     *
     * @throws IllegalStateException if a board of that name is plugged in
     */
    public void replug() {
        SimulatedBoards.plugIn(name, sketch);
    }

    /** Waits until somebody has the port open; fails after {@code timeoutMillis}. */
    public void awaitOpen(int timeoutMillis) {
        sketch.awaitOpen(timeoutMillis);
    }

    public List<String> received() {
        return record.received();
    }

    /** The messages that the board has handled so far, each with its time. */
    public List<ReceivedMessage> receivedMessages() {
        return record.receivedMessages();
    }

    /** The messages that later messages overwrote before the board handled them. */
    public List<String> overwritten() {
        return record.overwritten();
    }

    /**
     * Takes the next message that no rule covers; waits for one if necessary.
     *
     * @param timeoutMillis milliseconds to wait at most
     * @throws AssertionError if no such message came; lists the messages that came
     */
    public String awaitMessage(int timeoutMillis) {
        return record.take(message -> true, "a message", timeoutMillis);
    }

    /** Like {@link #awaitMessage(int)}, but takes only {@code message}; other messages stay. */
    public void awaitMessage(String message, int timeoutMillis) {
        record.take(message::equals, '"' + message + '"', timeoutMillis);
    }

    /**
     * Waits until the board has received everything that was sent to it, at most {@value #MAX_DRAIN_MILLIS} ms. Does not wait for a
     * {@linkplain #stall stalled} board. After the wait, fails if a message was surprising, missing or lost, unless the board is lenient.
     *
     * @throws AssertionError that lists the faults and all messages received
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

    /** Tells how a board handles a message: answers after a delay, or stays silent. */
    public static final class Rule {
        volatile int delayMillis;
        volatile boolean refused;
        volatile int outcomeMillis; // 0: the outcome is known at once
        volatile UnaryOperator<String> answer = message -> null;
        volatile Supplier<String> sensors = () -> "";
        volatile byte[] raw; // bytes sent in place of an answer; null: none

        Rule() {}

        /** Lets the board take {@code millis} milliseconds before it answers. In that time the board does nothing else. */
        public Rule after(int millis) {
            delayMillis = millis;
            return this;
        }

        /**
         * Answers with these messages in turn, and repeats the last one. The board compares the rules that it
         * {@linkplain FakeBoard#holdsRules holds} with the next answer.
         */
        public Rule answer(String first, String... next) {
            FakeBoardScript.InTurn answers = new FakeBoardScript.InTurn(first, next);
            return answer(message -> answers.next(), answers::current);
        }

        /**
         * Answers with the result of {@code answer} for the message; null: no answer. The board's thread calls the function for each
         * message, and every few milliseconds while the board watches rules.
         */
        public Rule answer(UnaryOperator<String> answer) {
            return answer(answer, () -> answer.apply(PerceptsRequest.ALL));
        }

        /**
         * Like {@link #answer(UnaryOperator)}.
         *
         * @param sensors gives the percepts to compare with the board's rules, every few milliseconds
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
         * Lets the board of version 2 begin the command at once, and report its outcome {@code millis} milliseconds later. Until the
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

        /** Refuses the message, like an unknown command; in version 1 the board stays silent. */
        public Rule refuse() {
            refused = true;
            return this;
        }
    }
}
