package javino.link;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import javino.LineClock;
import javino.Protocol;
import javino.session.CommandOutcome;
import javino.session.ComputerSession;
import javino.session.SessionListener;
import javino.wire.BoardAction;
import javino.wire.CommandItem;
import javino.wire.CriticalReport;
import javino.wire.FrameKind;
import javino.wire.VocabularyPage;
import javino.wire.Welcome;
import javino.wire.WireFrame;

/**
 * The session with a board of version 2. Makes its frames, and keeps its answers. Guarded by the line's lock. The caller holds the lock,
 * except for methods marked "Any thread".
 */
final class Version2Session implements SessionListener<Command>, Inbox.Listener {
    private static final int NONE = -1;
    /** The most bytes of an answer. Longer answers are dropped. */
    private static final int ANSWER_LIMIT = 65_536;

    private final Monitor monitor;
    private final LineClock clock;
    private final FrameWriter writer;
    private final BoardStatus board;
    private final LineReports reports;
    private final String port;
    private final ComputerSession<Command> session;
    private final CommandFailures failures;
    private volatile long movedNanos; // time of the board's last frame while a session is possible
    private long receivedNanos; // time of the last frame
    private volatile Reply answer;
    private volatile Reply heard; // newest percepts that came unasked
    private long askedBehind; // bytes written before the request for percepts; NONE if it has not gone out
    private int rules; // number of rules that the board can hold in this session
    private volatile int actionsLost;
    private Throwable
            failure; // failure for unacknowledged commands when the session closes; null: they are unconfirmed
    private boolean hasDropped; // whether an answer was dropped and no answer has come since
    private boolean hasToldLostActions;
    private boolean hasToldUnreadable;
    private boolean hasToldUndescribed;

    Version2Session(
            Monitor monitor,
            LineClock clock,
            FrameWriter writer,
            BoardStatus board,
            LineReports reports,
            String port,
            LinkSettings settings) {
        this.monitor = monitor;
        this.clock = clock;
        this.writer = writer;
        this.board = board;
        this.reports = reports;
        this.port = port;
        movedNanos = clock.nanos();
        session = new ComputerSession<>(
                settings.line().byteNanos(), ANSWER_LIMIT, new SplittableRandom(clock.nanos()), this);
        failures = new CommandFailures(port, session);
        if (board.mustSpeak2()) {
            session.open(clock.nanos());
        }
    }

    /** Any thread. */
    boolean isOpen() {
        return monitor.get(session::isOpen);
    }

    /** Returns HELLO for a board that may speak version 2. Any thread. */
    byte[] hello() {
        return monitor.get(() -> session.hello().toBytes(0));
    }

    /** Returns the time of the board's last frame while a session is possible. Any thread. */
    long movedNanos() {
        return movedNanos;
    }

    Optional<List<BoardAction>> vocabulary() {
        return board.speaks2() ? monitor.get(session::vocabulary) : Optional.empty();
    }

    int actionsLost() {
        return actionsLost;
    }

    void onBoardEvents(BoardListener listener) {
        int room = monitor.get(() -> {
            reports.listener(listener);
            return session.isOpen() ? rules : NONE;
        });
        if (room != NONE) {
            listener.sessionBegan(room);
        }
    }

    /** Asks for percepts until {@link #cancelRequest}. Any thread. */
    void request(String functors) {
        monitor.change(() -> {
            answer = null;
            askedBehind = NONE;
            session.request(functors, clock.nanos());
        });
    }

    /** Any thread. */
    void cancelRequest() {
        monitor.change(session::cancelRequest);
    }

    /** Returns the answer to the last request, or null. Any thread. */
    Reply answer() {
        return answer;
    }

    /** Returns whether percepts have come unasked. Any thread. */
    boolean hasHeard() {
        return heard != null;
    }

    /** Takes the newest percepts that came unasked, or null. Any thread. */
    Reply takeHeard() {
        return monitor.get(() -> {
            Reply newest = heard;
            heard = null;
            return newest;
        });
    }

    boolean isExpecting() {
        return session.isExpecting();
    }

    long nanosUntilNext(long now) {
        return Math.max(writer.nanosUntilFrame(), session.nanosUntilNext(now, writer));
    }

    /** Returns the frame to write now, or null. The frame keeps its session's nonce even if another session begins before the write. */
    SharedLine.Outgoing next(long now) {
        WireFrame frame = writer.nanosUntilFrame() > 0 ? null : session.next(now, writer);
        if (frame == null) {
            return null;
        }
        if (frame.kind() == FrameKind.ASK && askedBehind == NONE) {
            askedBehind = writer.written();
        }
        return new SharedLine.Outgoing(frame.toBytes(session.nonce()), null);
    }

    void wrote(long leavesAt) {
        session.wrote(leavesAt);
    }

    /** Fails the unacknowledged commands. Begins another session if the line is still open. */
    void abandon(Throwable why) {
        failure = why;
        session.close(clock.nanos());
        failure = null;
        if (board.speaks2() && writer.hasLine()) {
            session.open(clock.nanos());
        }
    }

    @Override
    public void received(WireFrame frame, long now) {
        receivedNanos = now;
        session.received(frame, now);
        if (board.noSession().isEmpty()) { // while no session is possible, waiting commands must fail in time
            movedNanos = now;
        }
        if (session.isSettled()) {
            writer.allArrived(now);
        }
    }

    @Override
    public void receiving(int bytes, long now) {
        session.receiving(now);
        writer.received(bytes, now);
    }

    @Override
    public int nonce() {
        return session.nonce();
    }

    @Override
    public void damaged() {
        session.damaged();
    }

    @Override
    public void sendsVersion1(long now) {
        session.sendsVersion1(now);
    }

    @Override
    public void found() {
        board.foundVersion2();
    }

    @Override
    public void otherRevision(int revision) {
        if (board.foundRevision(revision)) {
            reports.warn("port " + port + ": " + board.noSession().orElseThrow()
                    + (board.mustSpeak2()
                            ? ""
                            : "; until then version 1 is used with it, in which commands are not confirmed"));
        }
        if (!board.mustSpeak2() && board.speaks2()) { // the board or its sketch was replaced
            session.close(clock.nanos());
            lapsed();
        }
    }

    @Override
    public void began(Welcome welcome) {
        board.sessionBegan();
        rules = welcome.rules();
        actionsLost = welcome.actionsLost();
        if (actionsLost > 0 && !hasToldLostActions) {
            hasToldLostActions = true;
            reports.warn("port " + port + ": " + actionsLost
                    + " actions of the board's program found no room, and it refuses them; a board has "
                    + (CommandItem.MAX_ACTION + 1)
                    + " at most, of names with at most 250 characters, and fewer in little memory: give it more "
                    + "memory, as JavinoSized<600> javino; does, or fewer actions");
        }
        reports.call(called -> called.sessionBegan(welcome.rules()));
    }

    @Override
    public void ended(Command command, CommandOutcome outcome) {
        if (outcome == CommandOutcome.DONE || outcome == CommandOutcome.REFUSED) {
            writer.provedRead(command.beganBehind());
        }
        boolean isAbandoned = outcome == CommandOutcome.UNCONFIRMED && failure != null;
        reports.ended(command, isAbandoned ? failure : failures.of(command, outcome));
    }

    @Override
    public void answered(String percepts) {
        hasDropped = false;
        writer.provedRead(askedBehind);
        answer = new Reply(percepts, Protocol.V2, receivedNanos);
    }

    @Override
    public void heard(String percepts) {
        heard = new Reply(percepts, Protocol.V2, receivedNanos);
    }

    @Override
    public void dropped() {
        if (!hasDropped) {
            hasDropped = true;
            reports.warn(
                    "port " + port + " sent percepts of more than " + ANSWER_LIMIT
                            + " bytes, which are dropped; others are dropped without a warning until an answer comes that is not too long");
        }
    }

    @Override
    public void unreadable(FrameKind kind) {
        if (!hasToldUnreadable) {
            hasToldUnreadable = true;
            reports.warn("port " + port + " sent a frame " + kind
                    + " that cannot be read here, so it is dropped; further ones are dropped without a warning."
                    + " Does the board run the library of this version of ARGO?");
        }
    }

    @Override
    public void undescribed(int described, int total) {
        if (!hasToldUndescribed) {
            hasToldUndescribed = true;
            reports.warn("port " + port + ": the board describes " + described + " of its " + total
                    + " actions and no more, so none of them is known here; is the name of the next one longer than "
                    + VocabularyPage.MAX_NAME + " bytes, which no page of the vocabulary holds?");
        }
    }

    @Override
    public void reported(CriticalReport report) {
        long received = receivedNanos;
        reports.call(called -> called.critical(report.rule(), report.outcome(), report.percept(), received));
    }

    @Override
    public void lapsed() {
        board.lapsed();
        if (board.mustSpeak2()) {
            session.open(clock.nanos());
        }
    }
}
