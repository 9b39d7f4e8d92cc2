package javino;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import javino.wire.CommandItem;

/**
 * Takes the commands of a line from its queue to the board, on the threads that call {@link #run} and {@link #sendAndAwait}. Whichever of
 * these is free takes the next command, its own or another's. If the line is free, the submitting thread writes its command at once.
 * Outcomes are reported outside of any lock, on the thread that finds them out; exceptions of their dependents end no thread.
 */
final class CommandLoop {
    /** Returns when the board can be sent a command. */
    interface Start {
        void await() throws PortException;
    }

    private static final System.Logger LOG = System.getLogger(CommandLoop.class.getName());
    private static final long PATIENCE_NANOS = TimeUnit.MILLISECONDS.toNanos(FrameWriter.PATIENCE_MILLIS);

    private final String port;
    private final Monitor monitor;
    private final FrameWriter writer;
    private final SessionLine line;
    private final RequestChannel channel;
    private final LineClock clock;
    private final Start start;
    private final OneWaySender oneWay;
    private volatile long movedNanos; // time at which commands of version 1 last got through, or could begin to
    private Long toldNanos; // value of movedNanos() when the log was told that nothing gets through

    /** @param monitor the one of the writer and the line */
    CommandLoop(
            Monitor monitor,
            Transport transport,
            FrameWriter writer,
            SessionLine line,
            RequestChannel channel,
            LineClock clock,
            Start start) {
        port = transport.name();
        this.monitor = monitor;
        this.writer = writer;
        this.line = line;
        this.channel = channel;
        this.clock = clock;
        this.start = start;
        oneWay = new OneWaySender(port, writer, line.inbox(), clock);
        movedNanos = clock.nanos();
    }

    /** Queues a command, and writes it if that waits for nothing; see {@link Link#send(String, SendOptions)}. */
    Command submit(Frame frame, SendOptions options) {
        return submit(new Command(frame, options, clock.nanos()), options);
    }

    /** Like {@link #submit(Frame, SendOptions)}, for a command that changes the board's rules. */
    Command submit(CommandItem.Rule rule, SendOptions options) {
        return submit(new Command(rule, options, clock.nanos()), options);
    }

    private Command submit(Command command, SendOptions options) {
        String trouble = line.vocabulary()
                .filter(actions -> command.rule() == null)
                .map(actions -> ActionCheck.trouble(command.text(), actions))
                .orElse(null);
        if (trouble != null) {
            fail(
                    command,
                    new ActionRefusedException(
                            port, "the board at port " + port + " refuses \"" + command.text() + "\": " + trouble));
            return command;
        }
        command.outcome().whenComplete((done, failure) -> writer.reported());
        try {
            queue(command);
        } catch (PortGoneException gone) {
            fail(command, gone);
        } catch (PortException | RuntimeException | Error unforeseen) { // thrown by a transport
            fail(command, unforeseen);
        }
        if (options.limitMillis() > 0 && !command.isOver()) {
            clock.schedule(
                    TimeUnit.MILLISECONDS.toNanos(options.limitMillis()), () -> fail(command, timeOver(command)));
        }
        return command;
    }

    /** Work to be done without the lock. */
    private interface Writing {
        void run() throws PortException;
    }

    /** Queues a command. If it may be written now, it is begun under the same lock, so that no thread is woken for it, and written here. */
    private void queue(Command command) throws PortException {
        List<Command> replaced = new ArrayList<>();
        Writing writing = monitor.get(() -> {
            replaced.addAll(writer.submit(command));
            return writer.isWritableNow() ? beginAtOnce(command) : null;
        });
        replaced.forEach(earlier -> fail(earlier, replaced(earlier, command)));
        if (writing != null) {
            writing.run();
        }
    }

    private Writing beginAtOnce(Command command) {
        if (line.isVersion2()) {
            byte[] frame = line.nextAtOnce();
            return frame == null ? null : () -> line.write(frame);
        }
        return !channel.mustAsk() && writer.beginAtOnce(command) ? () -> writeAtOnce(command) : null;
    }

    private void writeAtOnce(Command command) throws PortException {
        try {
            writer.leaves(oneWay.writeAtOnce(command));
        } catch (PortException | RuntimeException | Error trouble) {
            writer.finish();
            throw trouble;
        }
    }

    /** Sends commands until the line ends or the thread is interrupted. */
    void run() throws PortException {
        movedNanos = clock.nanos();
        while (true) {
            giveUpStuck();
            if (line.isVersion2()) {
                runVersion2();
            } else if (writer.awaitWork(null, 0, line::isVersion2)) {
                sendNext(patienceEnds());
            }
        }
    }

    private void runVersion2() throws PortException {
        try {
            line.await(
                    () -> !line.isVersion2() || writer.isLeaving() || isStuck(),
                    clock.nanos() + Monitor.FOREVER,
                    false);
        } catch (RuntimeException | Error unforeseen) { // a transport's
            LOG.log(System.Logger.Level.ERROR, "port " + port + " failed while commands were sent", unforeseen);
            line.abandon(unforeseen);
        }
        finishLeaving();
    }

    /** The time at which commands last got through, or, in version 2, at which the board was last heard. */
    private long movedNanos() {
        return line.isVersion2() ? line.heardNanos() : movedNanos;
    }

    /** The time at which to look again whether a waiting command is to be given up, unless one gets through. */
    private long patienceEnds() {
        long moved = movedNanos();
        long now = clock.nanos();
        long since = now - moved >= PATIENCE_NANOS ? writer.waitingSince().orElse(now) : moved;
        return (since - moved > 0 ? since : moved) + PATIENCE_NANOS;
    }

    /** Returns whether a command without a time limit has waited for {@link #PATIENCE_NANOS}, and none has got through meanwhile. */
    private boolean isStuck() {
        long now = clock.nanos();
        if (now - movedNanos() < PATIENCE_NANOS) {
            return false;
        }
        OptionalLong since = writer.waitingSince();
        return since.isPresent() && now - since.getAsLong() >= PATIENCE_NANOS;
    }

    /**
     * Fails all commands without a time limit that have waited for {@link #PATIENCE_NANOS} together, so that none goes out late when the
     * line moves again.
     */
    private void giveUpStuck() {
        if (!isStuck()) {
            return;
        }
        long before = clock.nanos() - PATIENCE_NANOS;
        List<Command> stuck =
                writer.withdrawIf(command -> !command.hasTimeLimit() && command.submittedAt() - before <= 0);
        Long moved = movedNanos();
        if (!stuck.isEmpty() && !moved.equals(toldNanos)) {
            toldNanos = moved;
            LOG.log(
                    System.Logger.Level.WARNING,
                    "port " + port + ": commands that have waited for " + FrameWriter.PATIENCE_MILLIS + " ms fail, "
                            + stuck.size() + " of them now: " + line.noSession().orElseGet(writer::whyNoTime)
                            + "; this is not reported again until one gets through");
        }
        stuck.forEach(command -> fail(command, stuck(command)));
    }

    private PortTimeoutException stuck(Command command) {
        return line.noSession()
                .map(why -> new PortTimeoutException(port, why))
                .orElseGet(() -> writer.noTime(command.frame().length(), FrameWriter.PATIENCE_MILLIS));
    }

    /** Sends a command and returns when it has arrived; see {@link Link#sendAndAwait}. */
    void sendAndAwait(Frame frame, SendOptions options, int timeoutMillis) throws PortException {
        Command own = submit(frame, options);
        try {
            if (channel.mustAsk()) {
                start.await();
            }
            long deadline = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
            while (!own.isOver()) {
                if (own.isWaiting() && deadline - clock.nanos() <= 0 && writer.withdraw(own)) {
                    fail(own, writer.noTime(frame.length(), timeoutMillis));
                } else if (line.isVersion2()) {
                    finishLeaving();
                    line.await(
                            () -> own.isOver() || !line.isVersion2(),
                            own.isWaiting() ? deadline : clock.nanos() + PATIENCE_NANOS,
                            false);
                } else if (writer.awaitWork(own, deadline, line::isVersion2)) {
                    sendNext(deadline);
                }
            }
            join(own);
        } finally {
            writer.withdraw(own);
        }
    }

    private static void join(Command command) throws PortException {
        try {
            command.outcome().join();
        } catch (CompletionException e) {
            if (e.getCause() instanceof PortException trouble) {
                throw trouble;
            }
            throw e;
        }
    }

    /** Sends the command of version 1 whose turn is next, if it comes by {@code deadline}. */
    private void sendNext(long deadline) throws PortException {
        if (finishLeaving()) {
            return;
        }
        try {
            if (channel.mustAsk()) {
                start.await();
                movedNanos = channel.mustAsk() ? movedNanos : clock.nanos();
            }
        } catch (PortTimeoutException
                | RuntimeException
                | Error trouble) { // the latter is thrown by a transport; the commands behind go on
            fail(writer.withdrawNext(), trouble);
        }
        if (line.isVersion2() || line.hasLapsed()) {
            return;
        }
        Command command = writer.awaitCommand(deadline, line::isVersion2);
        if (command != null) {
            boolean isHeldBack = writer.isHeldBack(); // then an urgent one has no meaning for the others
            boolean hasLeft = end(command, () -> oneWay.awaitLeft(command, oneWay.write(command)));
            movedNanos = hasLeft && !isHeldBack ? clock.nanos() : movedNanos;
        }
    }

    /** Waits for the command that its submitter wrote; false: there is none. */
    private boolean finishLeaving() throws PortException {
        Command leaving = writer.takeLeaving();
        if (leaving == null) {
            return false;
        }
        boolean isHeldBack = writer.isHeldBack();
        boolean hasLeft = end(leaving, () -> oneWay.awaitLeft(leaving, writer.leavesAt()));
        movedNanos = hasLeft && !isHeldBack ? clock.nanos() : movedNanos;
        return true;
    }

    /** The rest of the work on the command under way. */
    private interface Transmission {
        void run() throws PortException;
    }

    /** @return whether it has arrived */
    private boolean end(Command command, Transmission rest) throws PortException {
        Throwable failure = failureOf(rest);
        writer.finish();
        if (failure == null) {
            command.outcome().complete(null);
        } else {
            fail(command, failure);
        }
        if (failure instanceof PortGoneException gone) {
            throw gone;
        }
        return failure == null;
    }

    private Throwable failureOf(Transmission rest) {
        try {
            rest.run();
            return null;
        } catch (PortTimeoutException trouble) {
            return goneOr(trouble);
        } catch (PortException | RuntimeException | Error trouble) {
            return trouble; // the commands behind it must go on, whatever a transport throws
        }
    }

    /**
     * Returns the exception of the line if it is gone, since a write that takes too long may be the first sign of that; else
     * {@code trouble}.
     */
    private PortException goneOr(PortTimeoutException trouble) {
        try {
            line.inbox().look();
            return trouble;
        } catch (PortException gone) {
            return gone;
        }
    }

    private PortException replaced(Command earlier, Command later) {
        return new CommandReplacedException(
                port,
                '"' + earlier.text() + "\" had not begun to go out through port " + port + " when \"" + later.text()
                        + "\" took its place, so it was not sent");
    }

    /** Withdraws a command whose time is over, if it has not begun to go out. */
    private PortException timeOver(Command command) {
        String subject = '"' + command.text() + '"';
        return writer.withdraw(command)
                ? new CommandWithdrawnException(
                        port,
                        subject + " had not begun to go out through port " + port
                                + " when its time was over, so it was not sent; other commands, or the board, take the line's time")
                : new ActionUnconfirmedException(
                        port,
                        subject + " was on its way through port " + port
                                + " when its time was over, and is not known to have arrived; it may have been carried out");
    }

    /** Fails the commands that wait or are on their way, on a line that is gone for {@code reason}. */
    void failAll(String reason) {
        PortGoneException gone = new PortGoneException(port, reason);
        writer.withdrawIf(command -> true).forEach(command -> fail(command, new PortGoneException(port, reason)));
        fail(writer.takeLeaving(), gone);
        line.abandon(gone);
    }

    private static void fail(Command command, Throwable failure) {
        if (command != null) {
            command.outcome().completeExceptionally(failure);
        }
    }
}
