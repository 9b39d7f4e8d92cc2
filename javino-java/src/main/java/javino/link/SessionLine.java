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
 * Carries the frames of a line: those of a {@link Version2Session}, and {@link Version1Commands}. Each thread that waits for something here
 * works for all: it writes the frame that is due, and reads if no other thread reads. The thread that learns an outcome or a report passes
 * it on. Safe on any thread; no lock is held while bytes are written or awaited, nor while a report is passed on.
 */
final class SessionLine {
    /** The longest single read while a frame is being written: another frame may be due behind it. */
    private static final long LOOK_WHILE_WRITING_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

    private static final long MAX_READ_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    /** The shortest time limit of a write. With a shorter limit a late thread would pass for a driver that takes nothing. */
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

    /** A frame that goes out, with its command of version 1; null: the frame belongs to the session. */
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

    /** Records that commands of version 1 can get through from now on, or that the next one may go out without an answer. */
    void hasAsked() {
        monitor.change(() -> version1.hasAsked(clock.nanos()));
    }

    /** The time at which commands last got through, or could first do so; in version 2, at which the board was last heard. */
    long movedNanos() {
        return board.speaks2() ? session.movedNanos() : version1.movedNanos();
    }

    /** Records that a thread sends commands from now on. */
    void sends() {
        version1.moved(clock.nanos());
    }

    /**
     * Writes and reads on this thread until {@code isDone} returns true, called under the lock, or until {@code deadline}.
     * @param reads whether this thread reads although nothing is expected. A thread that reads leaves the commands of version 1 to other
     *     threads: a driver may take longer over a command than this thread waits
     * @return whether {@code isDone} returned true
     */
    boolean await(BooleanSupplier isDone, long deadline, boolean reads) throws PortException {
        return await(isDone, () -> deadline, reads, () -> deadline - clock.nanos());
    }

    /**
     * Like {@link #await}, for the thread that writes the commands: a driver has its whole time for a frame, whenever the wait ends.
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

    /** Reads or waits until a frame is due, and returns it; null: the wait is over, or a report is to be passed on. */
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
     * Nanoseconds for one read. Nothing can end a read. During a read a follower may stop waiting, or a frame may fall due whose sender
     * does not wait. So the reader looks again and again for due frames. A follower writes such frames, and the read leaves time for that.
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

    /** Returns whether a thread that waits here has to read, since no other reads. */
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
     * Writes the frame that {@link #nextAtOnce} has returned, if it is not null. Afterwards writes the frames that have become due in the
     * meantime: the reading thread has found the line taken, and may read until an answer comes. Passes outcomes on. The caller holds no
     * lock.
     * @param millis the most milliseconds to wait for the driver with a frame of version 2; a frame of version 1 has longer. 0: no wait,
     *     since the caller has found the first frame {@linkplain FrameWriter#isWritableNow writable now}
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
            inbox.look(); // this shows whether the line is gone; if it is not, the frame is repeated
        }
    }

    /** Writes a command of version 1. Whatever a transport throws, the commands behind this one still go out. */
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

    /** Returns the line's exception if the line is gone, since a slow write may be the first sign of that; else {@code trouble}. */
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
