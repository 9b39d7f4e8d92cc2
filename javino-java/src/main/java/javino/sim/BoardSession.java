package javino.sim;

import java.util.List;
import javino.PerceptDescription;
import javino.PerceptTerm;
import javino.PerceptsRequest;
import javino.PortException;
import javino.sim.BoardProgram.Outcome;
import javino.wire.AnswerPart;
import javino.wire.BoardAction;
import javino.wire.CommandItem;
import javino.wire.CriticalReport;
import javino.wire.FrameKind;
import javino.wire.PerceptWriter;
import javino.wire.ReflexOutcome;
import javino.wire.VocabularyPage;
import javino.wire.Welcome;
import javino.wire.WireFrame;

/**
 * The board's side of version 2 of the protocol. The session takes and sends frames. The board's program handles commands and supplies
 * percepts.
 * <p>The session has no thread and no clock. The board's thread calls {@link #receive} and {@link #look}. {@link #sendPercepts} and
 * {@link #report} are safe on any thread. A frame goes out on the thread that causes it.
 */
public final class BoardSession {
    /** Takes the frames that the session sends. */
    @FunctionalInterface
    public interface Line {
        /**
         * Sends a frame. Several threads may call this at a time.
         *
         * @param nonce the nonce of the frame's session, or 0
         */
        void send(WireFrame frame, int nonce) throws PortException, InterruptedException;
    }

    /**
     * The capacity of a board.
     *
     * @param credit bytes of frames that the board holds while its program is busy, 0 to 255
     * @param longestPayload length of the longest payload that the board takes, 0 to 255
     * @param rules number of critical rules that the board can watch, 0 to 255
     * @param shapes number of shapes of percepts that the board can number, 0 to 126
     */
    public record Capacity(int credit, int longestPayload, int rules, int shapes) {
        /** The largest capacity of the protocol, but with 0 rules. */
        public static final Capacity FULL = new Capacity(255, WireFrame.MAX_PAYLOAD, 0, 126);

        /** Returns this capacity, with {@code value} rules. */
        public Capacity withRules(int value) {
            return new Capacity(credit, longestPayload, value, shapes);
        }
    }

    /** The most bytes of an answer in one frame while there are rules. Urgent frames then never wait for a long frame. */
    public static final int PART_WITH_RULES = 12;

    private static final int NUMBERS = 256;

    private final BoardProgram program;
    private final Capacity capacity;
    private final Line line;
    private final HeldRules rules;

    // this object guards the following fields
    private final PerceptWriter writer;
    private int nonce; // 0 if there is no session
    private int due;
    private boolean isRefused;
    private boolean isBusy;
    private int known;
    private long begun; // number of actions so far with a later outcome

    public BoardSession(BoardProgram program, Capacity capacity, Line line) {
        this.program = program;
        this.capacity = capacity;
        this.line = line;
        rules = new HeldRules(capacity.rules());
        writer = new PerceptWriter(capacity.shapes());
    }

    /** Returns the session's nonce, or 0 if there is no session. */
    public synchronized int nonce() {
        return nonce;
    }

    /** Returns whether there is a session. */
    public synchronized boolean isOpen() {
        return nonce != 0;
    }

    /** Handles a frame from the computer. */
    public void receive(WireFrame frame) throws PortException, InterruptedException {
        if (frame.kind() == FrameKind.HELLO && frame.number() != nonce()) { // a repeated HELLO begins no new session
            begin(frame.number());
        }
        if (frame.kind() == FrameKind.HELLO || !isOpen()) {
            sendWelcome();
            return;
        }
        switch (frame.kind()) {
            case ASK -> answer(frame);
            case DESCRIBE -> describe(frame);
            case COMMANDS, COMMANDS_WITH_RESUME -> handleCommands(frame);
            default -> throw new IllegalArgumentException("a board does not receive " + frame.kind());
        }
    }

    /** Ends the session, if there is one. Call this after a frame of version 1, because its sender knows of no session. */
    public void end() {
        begin(0);
    }

    private synchronized void begin(int value) {
        nonce = value;
        due = 0;
        isRefused = false;
        isBusy = false;
        known = 0;
        writer.forget();
        rules.clear();
    }

    private void sendWelcome() throws PortException, InterruptedException {
        send(
                FrameKind.WELCOME,
                new Welcome(
                                nonce(),
                                capacity.credit(),
                                capacity.longestPayload(),
                                capacity.rules(),
                                Welcome.REVISION,
                                Math.min(
                                        0xFF,
                                        program.vocabulary().size() - actions().size()))
                        .payload());
    }

    private void send(FrameKind kind, String payload) throws PortException, InterruptedException {
        WireFrame frame;
        int session;
        synchronized (this) {
            frame = new WireFrame(kind, isRefused, isBusy, due, payload);
            session = nonce;
        }
        line.send(frame, session);
    }

    // ---- commands ----

    private void handleCommands(WireFrame frame) throws PortException, InterruptedException {
        if (frame.kind() == FrameKind.COMMANDS_WITH_RESUME) {
            resume(frame.number());
        }
        int number = frame.number();
        for (CommandItem command : CommandItem.read(frame.payload())) {
            if (isNext(number)) {
                handled(carryOut(command));
            }
            number = (number + 1) % NUMBERS;
        }
        send(FrameKind.ACK, "");
    }

    private synchronized void resume(int number) {
        isRefused &= number != due;
    }

    private synchronized boolean isNext(int number) {
        return number == due && !isRefused && !isBusy;
    }

    private Outcome carryOut(CommandItem command) throws PortException, InterruptedException {
        if (command instanceof CommandItem.Action action) {
            List<BoardAction> actions = actions();
            return action.number() < actions.size() && takesNone(actions.get(action.number()))
                    ? program.carryOut(actions.get(action.number()).name())
                    : Outcome.REFUSED;
        }
        if (command instanceof CommandItem.Text text) {
            return program.carryOut(text.text());
        }
        return command instanceof CommandItem.Rule rule && !rules.change(rule) ? Outcome.REFUSED : Outcome.DONE;
    }

    private static boolean takesNone(BoardAction action) {
        return action.arguments() == 0 || action.arguments() == BoardAction.ANY;
    }

    private synchronized void handled(Outcome outcome) {
        isBusy = outcome == Outcome.LATER;
        if (isBusy) {
            begun++;
        } else {
            due = (due + 1) % NUMBERS;
            isRefused = outcome == Outcome.REFUSED;
        }
    }

    /** Returns a number for {@link #report}: that of the action without an outcome, or 0. */
    public synchronized long openAction() {
        return isBusy ? begun : 0;
    }

    /**
     * Reports the outcome of an action that returned {@link Outcome#LATER}. Ignores actions of earlier sessions.
     *
     * @param action the value of {@link #openAction} after the action began
     */
    public void report(long action, boolean isDone) throws PortException, InterruptedException {
        synchronized (this) {
            if (!isBusy || action != begun) {
                return;
            }
            handled(isDone ? Outcome.DONE : Outcome.REFUSED);
        }
        send(FrameKind.ACK, "");
    }

    // ---- percepts and vocabulary ----

    private void answer(WireFrame ask) throws PortException, InterruptedException {
        synchronized (this) {
            known = Math.min(firstByte(ask), writer.numbered());
        }
        String request = PerceptsRequest.ALL
                + ask.payload().substring(Math.min(1, ask.payload().length()));
        if (request.equals(PerceptsRequest.KINDS)) {
            sendItems(ask.number(), PerceptWriter.itemsWithoutIds(PerceptDescription.texts(program.perceptKinds())));
            return;
        }
        String answer = program.percepts(request);
        if (answer != null) {
            sendPercepts(ask.number(), answer);
        }
    }

    /** Sends percepts unasked, each followed by {@code ;}. Sends nothing if there is no session. */
    public void sendPercepts(String percepts) throws PortException, InterruptedException {
        if (isOpen()) {
            sendPercepts(0, percepts);
        }
    }

    private void sendPercepts(int request, String percepts) throws PortException, InterruptedException {
        String items;
        synchronized (this) {
            items = writer.items(PerceptTerm.split(percepts), known);
        }
        sendItems(request, items);
    }

    private void sendItems(int request, String items) throws PortException, InterruptedException {
        for (AnswerPart part : rules.isEmpty()
                ? AnswerPart.split(request, items)
                : AnswerPart.split(request, items, PART_WITH_RULES)) {
            send(part.kind(), part.payload());
        }
    }

    private void describe(WireFrame describe) throws PortException, InterruptedException {
        send(
                FrameKind.VOCABULARY,
                VocabularyPage.of(describe.number(), firstByte(describe), actions(), WireFrame.MAX_PAYLOAD)
                        .payload());
    }

    /** Returns the program's actions that have a number. The computer learns only how many other actions there are. */
    private List<BoardAction> actions() {
        return program.vocabulary().stream()
                .filter(action -> action.name().length() <= VocabularyPage.MAX_NAME)
                .limit(CommandItem.MAX_ACTION + 1)
                .toList();
    }

    private static int firstByte(WireFrame frame) {
        return frame.payload().isEmpty() ? 0 : frame.payload().charAt(0);
    }

    // ---- rules ----

    /** Returns whether there are rules to {@linkplain #look watch}. */
    public boolean hasRules() {
        return !rules.isEmpty();
    }

    /** Compares percepts with the rules. If a rule begins to match, carries out the rule's reflex and informs the computer. */
    public void look(String percepts) throws PortException, InterruptedException {
        for (HeldRules.Beginning beginning : rules.look(PerceptTerm.split(percepts))) {
            ReflexOutcome outcome = carryOutReflex(beginning.rule().reflex());
            send(FrameKind.CRITICAL, new CriticalReport(beginning.number(), outcome, beginning.percept()).payload());
        }
    }

    private ReflexOutcome carryOutReflex(String command) throws PortException, InterruptedException {
        if (command == null) {
            return ReflexOutcome.NONE;
        }
        return program.carryOut(command) == Outcome.REFUSED ? ReflexOutcome.REFUSED : ReflexOutcome.CARRIED_OUT;
    }
}
