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
 * Carries the frames of a line, from a {@link Version2Session} and from {@link Version1Commands}. Each waiting thread works for all
 * threads: it writes frames that are due, and reads if no other thread reads. The thread that first sees an outcome or a report passes it
 * on. Safe on any thread. Holds no lock while it reads, writes, or passes a report on.
 */
final class SharedLine {
    /** The longest single read during a write. Another frame may be due right after the write. */
    private static final long LOOK_WHILE_WRITING_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

    private static final long MAX_READ_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    /** The shortest time limit of a write. With a shorter limit, a delayed thread would look like a blocked driver. */
    private static final int LEAST_WRITE_MILLIS = 100;

    private final Monitor monitor;
    private final LineClock clock;
    private final FrameWriter writer;
    private final BoardStatus board;
    private final LineReports reports = new LineReports();
    private final Inbox inbox;
    private final Version2Session session;
    private final Version1Commands version1;
    private int followers;

    /** A frame to write, with its command of version 1. The command is null for a session's frame. */
    record Outgoing(byte[] frame, Command command) {}

    SharedLine(Monitor monitor, Transport transport, LineClock clock, FrameWriter writer, LinkSettings settings) {
        this.monitor = monitor;
        this.clock = clock;
        this.writer = writer;
        board = new BoardStatus(monitor, clock, settings);
        session = new Version2Session(monitor, clock, writer, board, reports, transport.name(), settings);
        inbox = new Inbox(monitor, transport, clock, board, session);
        version1 = new Version1Commands(writer, inbox, board, reports, transport.name(), clock.nanos());
    }

    BoardStatus board() {
        return board;
    }

    Inbox inbox() {
        return inbox;
    }

    Version2Session session() {
        return session;
    }

    /** Returns whether a request or HELLO must precede the waiting command. */
    boolean mustAskFirst() {
        return monitor.get(version1::mustAskFirst);
    }

    /**
     * Records that the board was asked. Commands of version 1 may go out now. If the board is still not ready, at least the next command
     * may.
     */
    void hasAsked() {
        monitor.change(() -> version1.hasAsked(clock.nanos()));
    }

    /**
     * Returns when the board last made progress. Version 1: the time at which a command last got through, or first could. Version 2: the
     * time of the board's last frame.
     */
    long movedNanos() {
        return board.speaks2() ? session.movedNanos() : version1.movedNanos();
    }

    /** Records that a thread sends commands from now on. */
    void sends() {
        version1.moved(clock.nanos());
    }

    /**
     * Writes and reads on this thread until {@code isDone} returns true, or until {@code deadline}. Calls {@code isDone} under the lock.
     * @param reads whether this thread reads even if nothing is expected. Such a thread leaves commands of version 1 to other threads: a
     *     driver may need more time for a command than this thread has
     * @return whether {@code isDone} returned true
     */
    boolean await(BooleanSupplier isDone, long deadline, boolean reads) throws PortException {
        return await(isDone, () -> deadline, reads, () -> deadline - clock.nanos());
    }

    /**
     * Like {@link #await}, for the thread that writes the commands. A driver gets its full time for a frame, even if the wait ends soon.
     * {@code deadline} is called repeatedly, under the lock.
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

    /** Reads or waits until a frame is due, and returns the frame. Returns null if the wait is over, or if a report must be passed on. */
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
     * Returns the nanoseconds for one read, which cannot be interrupted. Another thread's wait may end during the read, or a frame may
     * become due. The reader therefore stops regularly and looks for due frames. If other threads wait, they write due frames, so the
     * read may be a little longer.
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

    /** Returns whether a waiting thread has to read: bytes are wanted, and no other thread reads. */
    private boolean mustRead(boolean reads) {
        return (reads || session.isExpecting() && !writer.isWriting()) && !inbox.isBeingRead();
    }

    /**
     * Returns the nanoseconds until this thread has a frame to write or an outcome to pass on.
     *
     * @param reads see {@link #await}
     */
    private long nanosUntilNext(boolean reads) {
        if (reads && !board.speaks2()) {
            return Monitor.FOREVER;
        }
        long now = clock.nanos();
        long untilFrame = board.speaks2() ? session.nanosUntilNext(now) : version1.nanosUntilBegin();
        return Math.min(untilFrame, version1.nanosUntilArrived(now));
    }

    /** Returns the frame that {@link #write} may write now, or null. The caller holds the monitor's lock. */
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
     * Writes the frame from {@link #nextAtOnce}, if there is one. Then writes the frames that became due during the write, because a
     * reading thread may read until an answer comes. Passes outcomes on. The caller holds no lock.
     * @param millis the most milliseconds to wait for the driver to take a frame of version 2; a frame of version 1 gets more. 0: no
     *     wait. Pass 0 only if the line is {@linkplain FrameWriter#isWritableNow writable now}
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
            inbox.look(); // throws if the line is gone; else the session repeats the frame later
        }
    }

    /** Writes a command of version 1. If a transport throws, only this command fails. */
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

    /** If the line is gone, returns its exception, because a timeout may be the first sign of a lost line. Else returns {@code trouble}. */
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
