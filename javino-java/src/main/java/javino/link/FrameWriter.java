package javino.link;

import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import javino.LineClock;
import javino.PortException;
import javino.PortGoneException;
import javino.PortTimeoutException;
import javino.Transport;
import javino.session.WaitingCommands;

/**
 * Writes the frames of a line. Decides which command or request is next, and waits as long as the {@link Pacer} requires. In version 1,
 * requests go out before waiting commands. Safe on any thread. Holds no lock while bytes are written.
 */
final class FrameWriter implements WaitingCommands<Command> {
    /** The kinds of frames for the pacer: actions and requests of version 1, and any frame of version 2. */
    enum Kind {
        ACTION,
        REQUEST,
        SESSION
    }

    /** Makes a frame right before the write. Returns null if nothing needs to be written. */
    interface Content {
        byte[] make() throws PortException;
    }

    private static final System.Logger LOG = System.getLogger(FrameWriter.class.getName());

    private final Monitor monitor;
    private final CommandQueue commands = new CommandQueue();
    private final Transport transport;
    private final LineClock clock;
    private final Pacer pacer;
    private boolean isWriting;
    private int turnsAwaited; // number of requests and HELLOs that wait to be written
    private volatile long outcomeNanos;
    private long writtenBytes;
    private long readBytes; // number of written bytes that the far end has certainly read
    private final AtomicBoolean isRefused = new AtomicBoolean(); // whether the driver timed out on the last frame
    private String endReason; // null while the line is open

    FrameWriter(Monitor monitor, Transport transport, Pacer pacer, LineClock clock) {
        this.monitor = monitor;
        this.transport = transport;
        this.pacer = pacer;
        this.clock = clock;
        outcomeNanos = clock.nanos();
    }

    List<Command> submit(Command command) throws PortGoneException {
        return monitor.get(() -> {
            requireLine();
            return commands.add(command);
        });
    }

    /** Withdraws a command. Returns false if the command has begun to go out. */
    boolean withdraw(Command command) {
        monitor.change(command::withdraw);
        return command.isWithdrawn();
    }

    Command withdrawNext() {
        return monitor.get(() -> {
            Command next = commands.head();
            if (next != null) {
                next.withdraw();
            }
            return next;
        });
    }

    List<Command> withdrawIf(Predicate<Command> isGivenUp) {
        return monitor.get(() -> commands.withdrawIf(isGivenUp));
    }

    OptionalLong waitingSince() {
        return monitor.get(commands::waitingSince);
    }

    @Override
    public Command head() {
        return monitor.get(commands::head);
    }

    @Override
    public void begin() {
        monitor.change(() -> commands.head().begin(writtenBytes));
    }

    /**
     * Returns whether a thread can write a frame without waiting; see {@link Transport#isWritableNow}. The caller holds the monitor's
     * lock. The result holds until the lock is released, so call {@link #beginFrame} before.
     */
    boolean isWritableNow() {
        return !isWriting && hasRoom();
    }

    private boolean hasRoom() {
        return transport.isWritableNow(writtenBytes - readBytes);
    }

    long written() {
        return monitor.get(() -> writtenBytes);
    }

    /** Records that the far end has certainly read the first {@code bytes} of the {@link #written} bytes. */
    void provedRead(long bytes) {
        monitor.change(() -> readBytes = Math.max(readBytes, bytes));
    }

    /** Returns the nanoseconds until the next waiting command of version 1 may be written. The caller holds the monitor's lock. */
    long nanosUntilCommand() {
        Command next = commands.head();
        if (next == null || isWriting || turnsAwaited > 0) {
            return Monitor.FOREVER;
        }
        long now = clock.nanos();
        long held = next.isUrgent() ? 0 : pacer.nanosHeld(now);
        return held > 0 ? held : pacer.nanosUntilAction(next.frame().length(), now);
    }

    /** Returns whether only urgent commands of version 1 may go out until the board answers; see {@link Version1SilenceHold}. */
    boolean isHeldBack() {
        return monitor.get(() -> pacer.nanosHeld(clock.nanos()) > 0);
    }

    /** Returns whether the board's {@code loop()} seems to be longer than the gap between commands; see {@link Pacer#isSlow}. */
    boolean isBoardSlow() {
        return monitor.get(pacer::isSlow);
    }

    void reported() {
        monitor.change(() -> {
            commands.finished();
            outcomeNanos = clock.nanos();
        });
    }

    /** Returns the time of the last command outcome. If there is none, returns the time at which the line was opened. */
    long outcomeNanos() {
        return outcomeNanos;
    }

    /** Waits at most {@code nanos} until all commands submitted so far have ended. */
    void awaitCommandsSoFar(long nanos) throws PortException {
        monitor.getInterruptibly(() -> {
            long submitted = commands.submitted();
            long deadline = clock.nanos() + nanos;
            awaitZero(() -> commands.areOver(submitted) || isHeldBack() ? 0 : deadline - clock.nanos());
            return null;
        });
    }

    /** Returns a condition. The condition is true once all commands submitted before this call have begun to go out. */
    BooleanSupplier commandsSoFarHaveBegun() {
        long submitted = monitor.get(commands::submitted);
        return () -> monitor.get(() -> commands.haveBegun(submitted));
    }

    /**
     * Waits until the frame may be written, ahead of waiting commands, and writes it.
     *
     * @param bytes number of the frame's bytes
     * @param timeoutMillis milliseconds to wait at most for other frames. The pacer's gap on a free line is added to this time. The
     *     driver gets as much time again
     * @return the time, by the clock, at which the frame's last byte leaves the line
     * @throws PortTimeoutException if other frames took all the time, so nothing was written, or if the driver did not take the frame
     */
    long write(Kind kind, int bytes, int timeoutMillis, Content content) throws PortException {
        monitor.getInterruptibly(() -> {
            awaitTurn(kind, bytes, timeoutMillis);
            return null;
        });
        byte[] frame = null;
        try {
            frame = content.make();
        } finally {
            if (frame == null) {
                monitor.change(() -> isWriting = false);
            }
        }
        return frame == null ? clock.nanos() : writeFrame(kind, frame, timeoutMillis, left -> {});
    }

    private void awaitTurn(Kind kind, int bytes, int timeoutMillis) throws PortException {
        long due = clock.nanos();
        long limitMillis = (long) timeoutMillis + pacer.maxHoldMillis(); // the caller does not know the pacer's gap
        long deadline = due + TimeUnit.MILLISECONDS.toNanos(limitMillis);
        LongSupplier untilTurn = () -> isWriting
                ? Monitor.FOREVER
                : kind == Kind.ACTION
                        ? pacer.nanosUntilAction(bytes, clock.nanos())
                        : pacer.nanosUntilRequest(due, clock.nanos());
        turnsAwaited++;
        try {
            awaitZero(() -> Math.min(untilTurn.getAsLong(), deadline - clock.nanos()));
            if (untilTurn.getAsLong() > 0) {
                throw noTime(bytes, limitMillis);
            }
            isWriting = true;
        } finally {
            monitor.change(() -> turnsAwaited--);
        }
    }

    PortTimeoutException noTime(int bytes, long timeoutMillis) {
        return new PortTimeoutException(
                transport.name(),
                "port " + transport.name() + " had no time for a message of " + bytes + " bytes within " + timeoutMillis
                        + " ms; " + whyNoTime());
    }

    String whyNoTime() {
        return isHeldBack()
                ? "the board does not answer, and would lose commands, which wait until it does"
                : "the line is busy with the messages before it, or the board takes long over them, as with delay(3000) in its loop()";
    }

    /** Marks the line as busy with a frame, before {@link #writeFrame}. The caller holds the monitor's lock. */
    void beginFrame() {
        isWriting = true;
    }

    /**
     * Writes a frame after {@link #beginFrame}. Passes {@code whenWritten} the time at which the frame's last byte leaves, even if the
     * write fails. The caller does not hold the monitor's lock.
     * @param timeoutMillis milliseconds to wait at most for the driver; 0 if the line {@link #isWritableNow}
     * @return the time at which the frame's last byte leaves
     */
    long writeFrame(Kind kind, byte[] frame, int timeoutMillis, LongConsumer whenWritten) throws PortException {
        long start = clock.nanos();
        boolean waits = monitor.get(() -> {
            boolean isTight = timeoutMillis > 0 && !hasRoom();
            writtenBytes += frame.length;
            return isTight;
        });
        try {
            transport.write(frame, 0, frame.length, waits ? timeoutMillis : 0);
        } catch (PortException | RuntimeException | Error failure) {
            left(kind, frame.length, start, whenWritten); // some bytes may be on the line
            if (failure instanceof PortTimeoutException refused) {
                warnOnce(refused);
            }
            throw failure;
        }
        isRefused.set(false);
        return left(kind, frame.length, start, whenWritten);
    }

    private long left(Kind kind, int bytes, long start, LongConsumer whenWritten) {
        return monitor.get(() -> {
            isWriting = false;
            long now = clock.nanos();
            long left =
                    switch (kind) {
                        case ACTION -> pacer.wroteAction(bytes, start, now);
                        case REQUEST -> pacer.wroteRequest(bytes, start, now);
                        case SESSION -> pacer.wroteFrame(bytes, start, now);
                    };
            whenWritten.accept(left);
            return left;
        });
    }

    private void warnOnce(PortTimeoutException refused) {
        if (!isRefused.getAndSet(true)) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    refused.getMessage() + "; this is not reported again until it takes bytes again");
        }
    }

    /** Returns whether a frame is being written. The caller holds the monitor's lock. */
    boolean isWriting() {
        return isWriting;
    }

    /** Returns the nanoseconds until a frame of version 2 may be written. The caller holds the monitor's lock. */
    long nanosUntilFrame() {
        return isWriting ? Monitor.FOREVER : pacer.nanosUntilFrame(clock.nanos());
    }

    void allArrived(long now) {
        monitor.change(() -> pacer.allArrived(now));
    }

    void awaitTime(long nanos) throws PortException {
        monitor.getInterruptibly(() -> {
            awaitZero(() -> nanos - clock.nanos());
            return null;
        });
    }

    private void awaitZero(LongSupplier nanosLeft) throws PortException {
        monitor.await(() -> endReason != null ? 0 : nanosLeft.getAsLong());
        requireLine();
    }

    void received(int bytes, long now) {
        monitor.change(() -> pacer.received(bytes, now));
    }

    /**
     * Records a complete message. If an answer is awaited, the message counts as the answer. Actions that waited for the answer may go
     * out now.
     */
    void answered(long now) {
        monitor.change(() -> pacer.answered(now));
    }

    /** Records at {@code now} that the answer to a request of version 1 did not come in time. */
    void unanswered(long now) {
        monitor.change(() -> pacer.unanswered(now));
    }

    /** Ends the line. Present and future waits throw {@link PortGoneException} with {@code reason}. */
    void end(String reason) {
        monitor.change(() -> endReason = endReason == null ? reason : endReason);
    }

    boolean hasLine() {
        return monitor.get(() -> endReason == null);
    }

    void requireLine() throws PortGoneException {
        String reason = monitor.get(() -> endReason);
        if (reason != null) {
            throw new PortGoneException(transport.name(), reason);
        }
    }
}
