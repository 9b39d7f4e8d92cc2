package javino.link;

import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import javino.LineClock;
import javino.PortException;
import javino.PortGoneException;
import javino.PortTimeoutException;
import javino.Transport;

/**
 * Carries the frames of a line: those of a {@link Version2Session}, and {@link Version1Commands}. Each thread that waits here works for all
 * threads: it writes frames that are due, and reads if no other thread reads. The thread that first sees an outcome or a report passes it
 * on. Safe on any thread; no lock is held while bytes are written or awaited, nor while a report is passed on.
 */
final class SessionLine {
    /** The longest single read while a frame is being written: another frame may be due right after. */
    private static final long LOOK_WHILE_WRITING_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

    private static final long MAX_READ_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    /** The shortest time limit of a write. With a shorter limit, a thread that is late would look like a driver that takes nothing. */
    private static final int LEAST_WRITE_MILLIS = 100;

    private final Monitor monitor;
    private final LineClock clock;
    private final FrameWriter writer;
    private final KnownBoard board;
    private final LineReports reports = new LineReports();
    private final Inbox inbox;
    private final Version2Session session;
    private final Version1Commands version1;
    private int followers;

    /** A frame that goes out, with its command of version 1. The command is null if the frame belongs to the session. */
    record Outgoing(byte[] frame, Command command) {}

    SessionLine(Monitor monitor, Transport transport, LineClock clock, FrameWriter writer, LinkSettings settings) {
        this.monitor = monitor;
        this.clock = clock;
        this.writer = writer;
        board = new KnownBoard(monitor, clock, settings);
        session = new Version2Session(monitor, clock, writer, board, reports, transport.name(), settings);
        inbox = new Inbox(monitor, transport, clock, board, session);
        version1 = new Version1Commands(writer, inbox, board, reports, transport.name(), clock.nanos());
    }

    KnownBoard board() {
        return board;
    }

    Inbox inbox() {
        return inbox;
    }

    Version2Session session() {
        return session;
    }

    /** Returns whether a command waits until the board has been asked for something. */
    boolean mustAskFirst() {
        return monitor.get(version1::mustAskFirst);
    }

    /** Records that the board was asked: commands of version 1 get through from now on, or at least the next one may go out unanswered. */
    void hasAsked() {
        monitor.change(() -> version1.hasAsked(clock.nanos()));
    }

    /** The time at which a command last got through, or first could (version 1), or at which the board was last heard (version 2). */
    long movedNanos() {
        return board.speaks2() ? session.movedNanos() : version1.movedNanos();
    }

    /** Records that a thread sends commands from now on. */
    void sends() {
        version1.moved(clock.nanos());
    }

    /**
     * Writes and reads on this thread until {@code isDone}, which is called under the lock, returns true, or until {@code deadline}.
     * @param reads whether this thread reads even if nothing is expected. Then it leaves the commands of version 1 to other threads: a
     *     driver may need more time for a command than this thread has
     * @return whether {@code isDone} returned true
     */
    boolean await(BooleanSupplier isDone, long deadline, boolean reads) throws PortException {
        return await(isDone, () -> deadline, reads, () -> deadline - clock.nanos());
    }

    /**
     * Like {@link #await}, for the thread that writes the commands: a driver gets its full time for a frame, however soon the wait ends.
     * {@code deadline} is called anew each time, under the lock.
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
                    write(frame, limitMillis(writeNanos.getAsLong()));
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

    private static int limitMillis(long left) {
        return (int)
                Math.max(LEAST_WRITE_MILLIS, Math.min(CommandLoop.STUCK_MILLIS, TimeUnit.NANOSECONDS.toMillis(left)));
    }

    /** Reads or waits until a frame is due, and returns the frame; null: the wait is over, or a report must be passed on. */
    private Outgoing nextUnless(BooleanSupplier isDone, LongSupplier deadline, boolean reads) throws PortException {
        while (true) {
            writer.requireLine();
            long left = deadline.getAsLong() - clock.nanos();
            if (isDone.getAsBoolean() || left <= 0 || !reports.isEmpty()) {
                return null;
            }
            Outgoing frame = board.speaks2() || !reads ? nextAtOnce() : null;
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
     * Nanoseconds for one read. A read cannot be ended early. During a read the wait of another thread may end, or a frame may become due
     * whose sender does not wait. So the reader stops in between to look for due frames. If other threads wait, a read is a little longer:
     * they write such frames.
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

    /** Returns whether a thread that waits here has to read: bytes are wanted, and no other thread reads. */
    private boolean mustRead(boolean reads) {
        return (reads || session.isExpecting() && !writer.isWriting()) && !inbox.isBeingRead();
    }

    /** Nanoseconds until this thread, which {@code reads} or not, has a frame to write or an outcome to pass on. */
    private long nanosUntilNext(boolean reads) {
        if (reads && !board.speaks2()) {
            return Monitor.FOREVER;
        }
        long now = clock.nanos();
        long untilFrame = board.speaks2() ? session.nanosUntilNext(now) : version1.nanosUntilBegin();
        return Math.min(untilFrame, version1.nanosUntilArrived(now));
    }

    /** The frame that may be written now, for {@link #write}; null: there is none. The caller holds the monitor's lock. */
    Outgoing nextAtOnce() {
        if (!writer.hasLine()) {
            return null;
        }
        long now = clock.nanos();
        version1.endArrived(now);
        Outgoing next = board.speaks2() ? session.next(now) : version1.next();
        if (next != null) {
            writer.beginFrame();
        }
        return next;
    }

    /**
     * Writes the frame that {@link #nextAtOnce} has returned, if it is not null. Afterwards writes the frames that became due meanwhile:
     * the reading thread could not write them, and may read until an answer comes. Passes outcomes on. The caller holds no lock.
     * @param millis the most milliseconds to wait for the driver to take a frame of version 2; a frame of version 1 gets more. 0: no wait,
     *     as the caller has found the line {@linkplain FrameWriter#isWritableNow writable now}
     */
    void write(Outgoing first, int millis) throws PortException {
        try {
            for (Outgoing next = first; next != null; next = nextBehind(millis > 0)) {
                if (next.command() == null) {
                    writeOfSession(next.frame(), millis);
                } else {
                    writeCommand(next, millis > 0 ? CommandLoop.STUCK_MILLIS : 0);
                }
            }
        } finally {
            report();
        }
    }

    private Outgoing nextBehind(boolean mayWait) {
        return monitor.get(() -> board.speaks2() && (mayWait || writer.isWritableNow()) ? nextAtOnce() : null);
    }

    private void writeOfSession(byte[] frame, int millis) throws PortException {
        try {
            writer.writeFrame(FrameWriter.Kind.SESSION, frame, millis, session::wrote);
        } catch (PortTimeoutException e) {
            inbox.look(); // throws if the line is gone; else the frame is repeated later
        }
    }

    /** Writes a command of version 1. Whatever a transport throws, the later commands still go out. */
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
        monitor.change(() -> version1.fail(next.command(), why));
        if (why instanceof PortGoneException gone) {
            throw gone;
        }
    }

    /** Returns the line's exception if the line is gone, of which a slow write may be the first sign; else {@code trouble}. */
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
        reports.passOn();
    }

    void abandon(Throwable why) {
        monitor.change(() -> {
            version1.abandon(why);
            session.abandon(why);
        });
        report();
    }
}
