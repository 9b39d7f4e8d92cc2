package javino.link;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.SplittableRandom;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import javino.LineClock;
import javino.PortException;
import javino.PortGoneException;
import javino.PortTimeoutException;
import javino.Protocol;
import javino.Transport;
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
 * Carries the frames of a line: those of a {@link ComputerSession}, and the commands of version 1. Each thread that waits for something
 * here works for all: it writes the frame that is due, and reads if no other thread does.
 *
 * <p>Safe on any thread. Outcomes and reports are passed on outside of the lock, by the thread that has found them out. No lock is held
 * while bytes are written or awaited.
 */
final class SessionLine implements SessionListener<Command>, Inbox.Listener {
    private static final System.Logger LOG = System.getLogger(SessionLine.class.getName());
    /** The longest single read while a frame is being written. Behind that frame, another may be due. */
    private static final long LOOK_WHILE_WRITING_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

    private static final long MAX_READ_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    /** The shortest time limit of a write: with less, a late thread would pass for a driver that takes nothing. */
    private static final int LEAST_WRITE_MILLIS = 100;

    private static final int NONE = -1;

    private final Monitor monitor;
    private final Transport transport;
    private final LineClock clock;
    private final FrameWriter writer;
    private final Inbox inbox;
    private final ComputerSession<Command> session;
    private final Version1Commands version1;
    private final CommandFailures failures;
    private final BoardStart start;
    private final Protocol wanted;
    private final int answerLimit;
    private final Queue<Runnable> reports = new ConcurrentLinkedQueue<>(); // passed on when the lock is free
    private final Deque<Reply> heard = new ArrayDeque<>(); // percepts that came unasked
    private volatile Protocol protocol;
    private volatile BoardListener listener; // null: nobody is called
    private volatile long heardNanos; // time at which the board was last known to be there
    private volatile boolean
            hasLapsed; // the board spoke version 2 and then fell silent, so that another one may be there
    private int rules; // number of rules that the board can hold, in this session
    private Reply answer;
    private boolean hasDropped; // an answer was dropped, and none has come since
    private Throwable failure; // failure of commands out while the session is closed; null: they are unconfirmed
    private boolean isAsked; // the wanted percepts have been requested, behind askedBehind bytes
    private long askedBehind;
    private int followers;
    private volatile int otherRevision = NONE; // revision of version 2 that the board speaks
    private volatile int actionsLost;
    private boolean hasToldLostActions;
    private boolean hasToldSlowBoard;
    private boolean hasToldUnreadable;
    private boolean hasToldUndescribed;

    /** A frame that goes out, and the command of version 1 that it is; null: it belongs to the session. */
    record Outgoing(byte[] frame, Command command) {}

    /**
     * @param monitor guards it, with the inbox and the writer
     * @param settings their {@link LinkSettings#bootMillis()} count from now
     */
    SessionLine(Monitor monitor, Transport transport, LineClock clock, FrameWriter writer, LinkSettings settings) {
        this.monitor = monitor;
        this.transport = transport;
        this.clock = clock;
        this.writer = writer;
        wanted = settings.protocol();
        answerLimit = settings.messageLimit();
        protocol = wanted;
        heardNanos = clock.nanos();
        start = new BoardStart(clock, settings.bootMillis());
        version1 = new Version1Commands(writer, clock.nanos(), this::mustAsk);
        inbox = new Inbox(monitor, transport, clock, wanted, this);
        session = new ComputerSession<>(
                settings.line().byteNanos(), answerLimit, new SplittableRandom(clock.nanos()), this);
        failures = new CommandFailures(transport.name(), session);
        if (wanted == Protocol.V2) {
            session.open(clock.nanos());
        }
    }

    Inbox inbox() {
        return inbox;
    }

    /** The version that is spoken; {@link Protocol#AUTO}: it is not known yet, or not any more. */
    Protocol protocol() {
        return protocol;
    }

    boolean isOpen() {
        return monitor.get(session::isOpen);
    }

    boolean isVersion2() {
        return protocol == Protocol.V2;
    }

    /** Speaks version 1 from now on, unless the board answers a HELLO after all. */
    void agreeOnVersion1() {
        monitor.change(() -> {
            hasLapsed = false;
            protocol = protocol == Protocol.AUTO ? Protocol.V1 : protocol;
        });
    }

    BoardStart start() {
        return start;
    }

    /** Returns whether the board has to be asked for something before it is sent a command of version 1. Any thread. */
    boolean mustAsk() {
        return !isVersion2() && (mustAnswer() || protocol == Protocol.AUTO && !start.hasSaidHello());
    }

    /** Returns whether a command of version 1 has to wait for an answer, and not only for WELCOME. */
    boolean mustAnswer() {
        return start.nanosLeft() > 0 || protocol == Protocol.AUTO && (start.hasHeard() || hasLapsed);
    }

    /** Returns whether a command waits until the board has been asked for something. */
    boolean mustAskFirst() {
        return monitor.get(() -> !isVersion2() && version1.mustAskFirst());
    }

    /** Records that commands of version 1 can begin to get through, or that the next may go out although the board did not answer. */
    void hasAsked() {
        monitor.change(() -> {
            if (!mustAsk()) {
                version1.moved(clock.nanos());
            } else if (!hasLapsed) {
                version1.goUnasked();
            }
        });
    }

    /** A HELLO to a board that may speak version 2. */
    byte[] hello() {
        return monitor.get(() -> session.hello().toBytes(0));
    }

    /** The time at which commands last got through, or could begin to; in version 2, at which the board was last heard. */
    long movedNanos() {
        return isVersion2() ? heardNanos : version1.movedNanos();
    }

    /** Records that a thread sends commands from now on. */
    void sends() {
        version1.moved(clock.nanos());
    }

    Optional<List<BoardAction>> vocabulary() {
        return isVersion2() ? monitor.get(session::vocabulary) : Optional.empty();
    }

    /** Sets the listener for the board's reports; it is called at once if a session has begun. */
    void onBoardEvents(BoardListener boardListener) {
        int room = monitor.get(() -> {
            listener = boardListener;
            return session.isOpen() ? rules : NONE;
        });
        if (room != NONE) {
            boardListener.sessionBegan(room);
        }
    }

    /**
     * Writes and reads on this thread until {@code isDone}, which is asked under the lock, or until the clock shows {@code deadline}.
     *
     * @param reads whether this thread reads although nothing is expected; then it leaves the commands of version 1 to other threads, since
     *     a driver may take longer over one than this thread waits
     * @return whether it is done
     */
    boolean await(BooleanSupplier isDone, long deadline, boolean reads) throws PortException {
        return await(isDone, () -> deadline, reads, () -> deadline - clock.nanos());
    }

    /**
     * Like {@link #await}, for the thread that writes the commands: a driver has its whole time for a frame, whenever the wait ends, and
     * {@code deadline} is asked anew, under the lock.
     */
    void serve(BooleanSupplier isDone, LongSupplier deadline) throws PortException {
        await(isDone, deadline, false, () -> Monitor.FOREVER);
    }

    private boolean await(BooleanSupplier isDone, LongSupplier deadline, boolean reads, LongSupplier writeNanos)
            throws PortException {
        try {
            while (true) {
                Outgoing frame = monitor.getInterruptibly(() -> nextUnless(isDone, deadline, reads));
                report();
                if (frame != null) {
                    write(frame, writeNanos.getAsLong(), true);
                } else if (monitor.get(isDone::getAsBoolean)) {
                    return true;
                } else if (monitor.get(() -> deadline.getAsLong() - clock.nanos() <= 0)) {
                    return false;
                }
            }
        } finally {
            report();
        }
    }

    /** Reads or waits until a frame is to be written now, and returns it; null: the wait is over, or something is to be passed on. */
    private Outgoing nextUnless(BooleanSupplier isDone, LongSupplier deadline, boolean reads) throws PortException {
        while (true) {
            writer.requireLine();
            long left = deadline.getAsLong() - clock.nanos();
            if (isDone.getAsBoolean() || left <= 0 || !reports.isEmpty()) {
                return null;
            }
            Outgoing frame = isVersion2() || !reads ? nextAtOnce() : null;
            if (frame != null || !reports.isEmpty()) {
                return frame;
            }
            if (version1.mustLook(clock.nanos()) && !inbox.isBeingRead()) {
                inbox.readFor(0);
            } else if (mustRead(reads)) {
                inbox.readFor(Math.min(left, nanosToRead()));
            } else {
                follow(isDone, deadline, reads);
            }
        }
    }

    /**
     * Nanoseconds for one read. A read cannot be ended, but meanwhile a follower may go, and a frame may go out whose sender waits for
     * nothing; so the reader looks again and again for frames that are due. A follower writes them, and is left the time for that.
     */
    private long nanosToRead() {
        if (writer.isWriting()) {
            return LOOK_WHILE_WRITING_NANOS;
        }
        long untilNext = Math.min(nanosUntilNext(true), MAX_READ_NANOS);
        return followers > 0 ? untilNext + LOOK_WHILE_WRITING_NANOS : untilNext;
    }

    private void follow(BooleanSupplier isDone, LongSupplier deadline, boolean reads) throws PortException {
        followers++;
        try {
            monitor.await(() -> isDone.getAsBoolean() || mustRead(reads) || !writer.hasLine()
                    ? 0
                    : Math.min(deadline.getAsLong() - clock.nanos(), nanosUntilNext(reads)));
        } finally {
            followers--;
        }
    }

    /** Returns whether a thread that waits here is to read, since no other does. */
    private boolean mustRead(boolean reads) {
        return (reads || session.isExpecting() && !writer.isWriting()) && !inbox.isBeingRead();
    }

    /** Nanoseconds until there is a frame to be written, or an outcome to be passed on, by a thread that {@code reads} or not. */
    private long nanosUntilNext(boolean reads) {
        if (reads && !isVersion2()) {
            return Monitor.FOREVER;
        }
        long now = clock.nanos();
        long untilFrame = isVersion2()
                ? Math.max(writer.nanosUntilFrame(), session.nanosUntilNext(now, writer))
                : version1.nanosUntilBegin();
        return Math.min(untilFrame, version1.nanosUntilArrived(now));
    }

    /** The frame that may be written now, which {@link #write} follows; null: there is none. The caller holds the monitor's lock. */
    Outgoing nextAtOnce() {
        if (!writer.hasLine()) {
            return null;
        }
        long now = clock.nanos();
        Command arrived = version1.takeArrived(now);
        if (arrived != null) {
            reports.add(() -> arrived.outcome().complete(null));
        }
        Outgoing next = isVersion2() ? nextOfSession(now) : nextOfVersion1();
        if (next != null) {
            writer.beginFrame();
        }
        return next;
    }

    /** Returns bytes of the current session, even if another session begins before they are written. */
    private Outgoing nextOfSession(long now) {
        WireFrame frame = writer.nanosUntilFrame() > 0 ? null : session.next(now, writer);
        if (frame == null) {
            return null;
        }
        if (frame.kind() == FrameKind.ASK && !isAsked) {
            isAsked = true;
            askedBehind = writer.written();
        }
        return new Outgoing(frame.toBytes(session.nonce()), null);
    }

    private Outgoing nextOfVersion1() {
        Command command = version1.begin();
        if (command == null) {
            return null;
        }
        if (command.rule() != null) {
            failUnderWay(failures.takesNoRules());
            return null;
        }
        if (writer.isBoardSlow() && !hasToldSlowBoard) {
            hasToldSlowBoard = true;
            reports.add(this::tellSlowBoard);
        }
        inbox.sends(command.frame());
        return new Outgoing(command.frame().toBytes(), command);
    }

    private void tellSlowBoard() {
        LOG.log(
                System.Logger.Level.WARNING,
                "the board at port " + transport.name() + " begins its answers more than " + LoopTime.MAX_MILLIS
                        + " ms late: a board of version 1 loses commands that come while its loop() does something else;"
                        + " give the port the option spacing(Ms) with the longest time of a loop(), or use version 2");
    }

    /** Fails the command of version 1 that is under way, if there is one. The caller holds the monitor's lock. */
    private void failUnderWay(Throwable failure) {
        Command command = version1.takeUnderWay();
        if (command != null) {
            reports.add(() -> command.outcome().completeExceptionally(failure));
        }
    }

    /** Writes a frame that {@link #nextAtOnce} has returned, if it is not null, and passes outcomes on. The caller holds no lock. */
    void write(Outgoing frame) throws PortException {
        try {
            write(frame, Long.MAX_VALUE, false);
        } finally {
            report();
        }
    }

    /**
     * Writes a frame, and those that have become due meanwhile: the reader has found the line taken, and may read until an answer comes.
     *
     * @param mayWait whether the driver may be waited for; else the first has been found to be {@linkplain FrameWriter#isWritableNow
     *     writable now}
     */
    private void write(Outgoing first, long left, boolean mayWait) throws PortException {
        for (Outgoing next = first; next != null; next = nextBehind(mayWait)) {
            if (next.command() == null) {
                writeOfSession(next.frame(), mayWait ? limitMillis(left) : 0);
            } else {
                writeCommand(next, mayWait ? FrameWriter.PATIENCE_MILLIS : 0);
            }
        }
    }

    private static int limitMillis(long left) {
        return (int) Math.max(
                LEAST_WRITE_MILLIS, Math.min(FrameWriter.PATIENCE_MILLIS, TimeUnit.NANOSECONDS.toMillis(left)));
    }

    private Outgoing nextBehind(boolean mayWait) {
        return monitor.get(() -> isVersion2() && (mayWait || writer.isWritableNow()) ? nextAtOnce() : null);
    }

    private void writeOfSession(byte[] frame, int millis) throws PortException {
        try {
            writer.writeFrame(FrameWriter.Kind.SESSION, frame, millis, session::wrote);
        } catch (PortTimeoutException e) {
            inbox.look(); // finds whether the line is gone; if not, the frame is repeated
        }
    }

    /** Writes a command of version 1. The commands behind it go on, whatever a transport throws. */
    private void writeCommand(Outgoing next, int millis) throws PortGoneException {
        Throwable failure;
        try {
            long left = writer.writeFrame(FrameWriter.Kind.ACTION, next.frame(), millis, at -> {});
            monitor.change(() -> version1.written(next.command(), left, clock.nanos()));
            return;
        } catch (PortTimeoutException trouble) {
            failure = goneOr(trouble);
        } catch (PortException | RuntimeException | Error trouble) {
            failure = trouble;
        }
        Throwable why = failure;
        monitor.change(() -> {
            if (version1.isUnderWay(next.command())) {
                failUnderWay(why);
            }
        });
        if (why instanceof PortGoneException gone) {
            throw gone;
        }
    }

    /**
     * Returns the exception of the line if it is gone, since a write that takes too long may be the first sign of that; else
     * {@code trouble}.
     */
    private PortException goneOr(PortTimeoutException trouble) {
        try {
            inbox.look();
            return trouble;
        } catch (PortException gone) {
            return gone;
        }
    }

    /** Passes outcomes and reports on. The caller holds no lock. */
    void report() {
        for (Runnable next = reports.poll(); next != null; next = reports.poll()) {
            next.run();
        }
    }

    /** Asks for percepts in version 2; null: no answer came by {@code deadline}, or the board speaks version 2 no more. */
    Reply request(String functors, long deadline) throws PortException {
        inbox.look(); // messages that came before the question are no answer to it
        monitor.change(() -> {
            answer = null;
            isAsked = false;
            session.request(functors, clock.nanos());
        });
        try {
            await(() -> answer != null || !isVersion2(), deadline, true);
            return monitor.get(() -> answer);
        } finally {
            monitor.change(session::cancelRequest);
        }
    }

    /** The newest percepts that came unasked; null: none came by {@code deadline}. */
    Reply listen(long deadline) throws PortException {
        await(() -> !heard.isEmpty() || !isVersion2(), deadline, true);
        return monitor.get(() -> {
            Reply newest = heard.peekLast();
            heard.clear();
            return newest;
        });
    }

    void forgetHeard() {
        monitor.change(heard::clear);
    }

    /** Fails the commands that are out, and begins another session if the line is still there. */
    void abandon(Throwable why) {
        monitor.change(() -> {
            failUnderWay(why);
            long now = clock.nanos();
            failure = why;
            session.close(now);
            failure = null;
            if (isVersion2() && writer.hasLine()) {
                session.open(now);
            }
        });
        report();
    }

    @Override
    public void received(WireFrame frame, long now) {
        session.received(frame, now);
        if (otherRevision == NONE) { // else no command would ever be given up
            heardNanos = now;
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
        protocol = Protocol.V2;
        hasLapsed = false;
        inbox.read(Protocol.V2);
    }

    @Override
    public void otherRevision(int revision) {
        if (otherRevision != revision) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "port " + transport.name() + ": " + otherRevisionInWords(revision)
                            + (wanted == Protocol.V2
                                    ? ""
                                    : "; until then version 1 is used with it, in which commands are not confirmed"));
        }
        otherRevision = revision;
        if (wanted != Protocol.V2 && isVersion2()) { // the board was exchanged, or its sketch
            session.close(clock.nanos());
            lapsed();
        }
    }

    private static String otherRevisionInWords(int revision) {
        return revision < Welcome.REVISION
                ? "the board speaks an older draft of version 2 of Javino, which is not spoken any more; upload its sketch again "
                        + "with the library of this version of ARGO (ArgoJavino, or the Python package javino)"
                : "the board speaks revision " + revision + " of version 2 of Javino, and this program only revision "
                        + Welcome.REVISION + "; use a newer version of ARGO";
    }

    /** The reason why there is no session with a board that has answered HELLO; empty: it has not, or there is one. */
    Optional<String> noSession() {
        return otherRevision == NONE ? Optional.empty() : Optional.of(otherRevisionInWords(otherRevision));
    }

    /** The number of actions of the board's program that found no room there, as far as is known. */
    int actionsLost() {
        return actionsLost;
    }

    @Override
    public void began(Welcome welcome) {
        found();
        otherRevision = NONE;
        actionsLost = welcome.actionsLost();
        if (actionsLost > 0 && !hasToldLostActions) {
            hasToldLostActions = true;
            LOG.log(
                    System.Logger.Level.WARNING,
                    "port " + transport.name() + ": " + actionsLost
                            + " actions of the board's program found no room, and it refuses them; a board has "
                            + (CommandItem.MAX_ACTION + 1)
                            + " at most, of names with at most 250 characters, and fewer in little memory: give it more "
                            + "memory, as JavinoSized<600> javino; does, or fewer actions");
        }
        rules = welcome.rules();
        notify(called -> called.sessionBegan(welcome.rules()));
    }

    @Override
    public void ended(Command command, CommandOutcome outcome) {
        if (outcome == CommandOutcome.DONE || outcome == CommandOutcome.REFUSED) {
            writer.provedRead(command.beganBehind());
        }
        Throwable why =
                outcome == CommandOutcome.UNCONFIRMED && failure != null ? failure : failures.of(command, outcome);
        reports.add(() -> {
            if (why == null) {
                command.outcome().complete(null);
            } else {
                command.outcome().completeExceptionally(why);
            }
        });
    }

    @Override
    public void answered(String percepts) {
        hasDropped = false;
        writer.provedRead(askedBehind);
        answer = new Reply(percepts, Protocol.V2, inbox.lastByteNanos());
    }

    @Override
    public void heard(String percepts) {
        if (heard.size() == Inbox.MAX_MESSAGES) {
            heard.poll();
        }
        heard.add(new Reply(percepts, Protocol.V2, inbox.lastByteNanos()));
    }

    @Override
    public void dropped() {
        if (!hasDropped) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "port " + transport.name() + " sent percepts of more than " + answerLimit
                            + " bytes, which are dropped; others are dropped without a warning until an answer comes that is not too long");
        }
        hasDropped = true;
    }

    @Override
    public void unreadable(FrameKind kind) {
        if (!hasToldUnreadable) {
            hasToldUnreadable = true;
            LOG.log(
                    System.Logger.Level.WARNING,
                    "port " + transport.name() + " sent a frame " + kind
                            + " that cannot be read here, so it is dropped, as are others without a further warning;"
                            + " does the board run the library of this version of ARGO?");
        }
    }

    @Override
    public void undescribed(int described, int total) {
        if (!hasToldUndescribed) {
            hasToldUndescribed = true;
            LOG.log(
                    System.Logger.Level.WARNING,
                    "port " + transport.name() + ": the board describes " + described + " of its " + total
                            + " actions and no more, so none of them is known here; is the name of the next one longer than "
                            + VocabularyPage.MAX_NAME + " bytes, which no page of the vocabulary holds?");
        }
    }

    @Override
    public void reported(CriticalReport report) {
        long receivedNanos = inbox.lastByteNanos();
        notify(called -> called.critical(report.rule(), report.outcome(), report.percept(), receivedNanos));
    }

    private void notify(Consumer<BoardListener> call) {
        BoardListener called = listener;
        if (called != null) {
            reports.add(() -> {
                try {
                    call.accept(called);
                } catch (RuntimeException | Error broken) { // the reader must go on
                    LOG.log(System.Logger.Level.ERROR, "who was called with what the board reports has failed", broken);
                }
            });
        }
    }

    @Override
    public void lapsed() {
        hasLapsed = true;
        if (wanted == Protocol.V2) {
            session.open(clock.nanos());
        } else {
            protocol = Protocol.AUTO;
            inbox.read(Protocol.AUTO);
        }
    }
}
