package javino;

import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * The one queue of a line: gives commands and requests their turns, each when the {@link Pacer} lets it, and writes their frames. One
 * command at a time is under way, from its turn until its outcome; requests go out meanwhile, and before the commands that wait.
 *
 * <p>Safe on any thread; no lock is held while bytes are written.
 */
final class FrameWriter {
    /** What a frame is for: the pacer treats the two differently. */
    enum Kind {
        ACTION,
        REQUEST
    }

    /** What is done after a frame's turn has come and right before it is written. */
    interface BeforeWrite {
        void run() throws PortException;
    }

    private final Monitor monitor;
    private final CommandQueue commands = new CommandQueue();
    private final Transport transport;
    private final LineClock clock;
    private final Pacer pacer;
    private boolean writing;
    private int turnsAwaited; // of requests and retransmissions
    private Command underWay;
    private String endReason; // null while the line is there

    FrameWriter(Transport transport, Pacer pacer, LineClock clock) {
        this.transport = transport;
        this.pacer = pacer;
        this.clock = clock;
        monitor = new Monitor(clock, transport.name());
    }

    /** Queues a command. */
    void submit(Command command) throws PortGoneException {
        monitor.change(() -> {
            requireLine();
            commands.add(command);
        });
    }

    /** Takes a command that has not begun to go out from the queue, for good; false if it has. */
    boolean withdraw(Command command) {
        monitor.change(command::withdraw);
        return command.isWithdrawn();
    }

    /** Withdraws the command whose turn is next; null if there is none. */
    Command withdrawNext() {
        return monitor.get(() -> {
            Command next = next();
            if (next != null) {
                next.withdraw();
            }
            return next;
        });
    }

    /** Withdraws all commands that wait. */
    List<Command> withdrawAll() {
        return monitor.get(commands::removeAll);
    }

    private Command next() {
        return underWay == null ? commands.head() : null;
    }

    /**
     * Waits until a command may be written next: until one waits and none is under way.
     *
     * @param own the wait ends when this command is over; null: it has no such end
     * @param deadline until when {@code own} may wait for its turn
     * @return whether there is one
     */
    boolean awaitWork(Command own, long deadline) throws PortException {
        return monitor.getInterruptibly(() -> {
            awaitZero(() -> own != null && own.isOver() || next() != null
                    ? 0
                    : own != null && own.isWaiting() ? deadline - clock.nanos() : Monitor.FOREVER);
            return (own == null || !own.isOver()) && next() != null;
        });
    }

    /**
     * Waits for the turn of the next command, which is under way from then on until {@link #finish}, and must be written with
     * {@link #writeNow}.
     *
     * @return null if its turn has not come by {@code deadline}, or there is none, or another thread has it
     */
    Command awaitCommand(long deadline) throws PortException {
        return monitor.getInterruptibly(() -> {
            awaitZero(() -> next() == null ? 0 : Math.min(nanosUntilNext(), deadline - clock.nanos()));
            Command next = next();
            if (next == null || nanosUntilNext() > 0) {
                return null;
            }
            next.begin();
            underWay = next;
            writing = true;
            return next;
        });
    }

    private long nanosUntilNext() {
        return writing || turnsAwaited > 0
                ? Monitor.FOREVER
                : pacer.nanosUntilAction(pacer.lengthOf(next().frame()), clock.nanos());
    }

    /** Records that the command under way has arrived, or failed: the next one may go. */
    void finish() {
        monitor.change(() -> underWay = null);
    }

    /** Records that the outcome of a command has been reported. */
    void reported() {
        monitor.change(commands::finished);
    }

    /** Waits, at most {@code nanos}, until the commands that have been submitted so far are over. */
    void awaitCommandsSoFar(long nanos) throws PortException {
        monitor.getInterruptibly(() -> {
            long submitted = commands.submitted();
            long deadline = clock.nanos() + nanos;
            awaitZero(() -> commands.areOver(submitted) ? 0 : deadline - clock.nanos());
            return null;
        });
    }

    /**
     * Waits for a turn of its own, before the commands that wait, and writes a frame.
     *
     * @param timeoutMillis milliseconds to wait at most for the turn, and again for the driver
     * @return when its last byte leaves the line, by the clock
     * @throws PortTimeoutException if its turn did not come in time, and then nothing was written; or if the driver did not take it
     */
    long write(Kind kind, Frame frame, int timeoutMillis, BeforeWrite beforeWrite) throws PortException {
        monitor.getInterruptibly(() -> {
            awaitTurn(kind, frame, timeoutMillis);
            return null;
        });
        return writeNow(kind, frame, timeoutMillis, beforeWrite);
    }

    private void awaitTurn(Kind kind, Frame frame, int timeoutMillis) throws PortException {
        long due = clock.nanos();
        long deadline = due + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        LongSupplier untilTurn = () -> writing
                ? Monitor.FOREVER
                : kind == Kind.ACTION
                        ? pacer.nanosUntilAction(frame.length(), clock.nanos())
                        : pacer.nanosUntilRequest(due, clock.nanos());
        turnsAwaited++;
        try {
            awaitZero(() -> Math.min(untilTurn.getAsLong(), deadline - clock.nanos()));
            if (untilTurn.getAsLong() > 0) {
                throw noTime(frame, timeoutMillis);
            }
            writing = true;
        } finally {
            monitor.change(() -> turnsAwaited--);
        }
    }

    /** Why a frame was not written whose turn did not come. */
    PortTimeoutException noTime(Frame frame, int timeoutMillis) {
        return new PortTimeoutException(
                transport.name(),
                "port " + transport.name() + " had no time for a message of " + frame.length() + " bytes within "
                        + timeoutMillis + " ms; the line is busy with those before it");
    }

    /** Writes a frame whose turn has come; as {@link #write}. */
    long writeNow(Kind kind, Frame frame, int timeoutMillis, BeforeWrite beforeWrite) throws PortException {
        byte[] bytes = frame.toBytes();
        try {
            beforeWrite.run();
            long start = clock.nanos();
            try {
                transport.write(bytes, 0, bytes.length, timeoutMillis);
            } catch (PortException | RuntimeException e) {
                wrote(kind, bytes.length, start); // some bytes may have left
                throw e;
            }
            return wrote(kind, bytes.length, start);
        } finally {
            monitor.change(() -> writing = false);
        }
    }

    private long wrote(Kind kind, int bytes, long start) {
        return monitor.get(() -> kind == Kind.ACTION
                ? pacer.wroteAction(bytes, start, clock.nanos())
                : pacer.wroteRequest(bytes, start, clock.nanos()));
    }

    /** Waits until the clock shows {@code nanos}. */
    void awaitTime(long nanos) throws PortException {
        monitor.getInterruptibly(() -> {
            awaitZero(() -> nanos - clock.nanos());
            return null;
        });
    }

    /** Waits until {@code nanosLeft}, which is asked again after each change, is 0 or less. */
    private void awaitZero(LongSupplier nanosLeft) throws PortException {
        while (true) {
            requireLine();
            long left = nanosLeft.getAsLong();
            if (left <= 0) {
                return;
            }
            monitor.await(left);
        }
    }

    /** Records that {@code bytes} have been read at {@code now}. */
    void received(int bytes, long now) {
        monitor.get(() -> {
            pacer.received(bytes, now); // changes nothing that is waited for
            return null;
        });
    }

    /** Records that a message is complete, the answer to the last request if one is awaited: actions go out that waited for it. */
    void answered(long now) {
        monitor.change(() -> pacer.answered(now));
    }

    /** Keeps the manners of version 2 from now on. */
    void speakVersion2() {
        monitor.change(pacer::speakVersion2);
    }

    /** Ends the line: who waits here, or comes later, gets a {@link PortGoneException} with {@code reason}. */
    void end(String reason) {
        monitor.change(() -> endReason = endReason == null ? reason : endReason);
    }

    /** Whether the line is still there, as far as it is known. */
    boolean hasLine() {
        return monitor.get(() -> endReason == null);
    }

    /** Does nothing on a line that is there; else throws with the first reason that {@link #end} was given. */
    void requireLine() throws PortGoneException {
        String reason = monitor.get(() -> endReason);
        if (reason != null) {
            throw new PortGoneException(transport.name(), reason);
        }
    }
}
