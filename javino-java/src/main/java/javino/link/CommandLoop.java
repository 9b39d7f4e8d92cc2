package javino.link;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import javino.ActionRefusedException;
import javino.ActionUnconfirmedException;
import javino.CommandReplacedException;
import javino.CommandWithdrawnException;
import javino.Frame;
import javino.LineClock;
import javino.PortException;
import javino.PortGoneException;
import javino.PortTimeoutException;
import javino.Transport;
import javino.wire.CommandItem;

/**
 * Sends the queued commands of a line on the threads that call {@link #run} and {@link #sendAndAwait}. Each of these threads sends any
 * thread's next command. If the line is free, the submitting thread writes its command at once. The thread that first sees an outcome
 * reports it, and holds no lock. An exception of an outcome's listener ends no thread.
 */
final class CommandLoop {
    private static final System.Logger LOG = System.getLogger(CommandLoop.class.getName());
    /** The longest wait of a command, in milliseconds, while no command gets through. Also the longest wait for the driver. */
    static final int STUCK_MILLIS = 5000;

    private static final long STUCK_NANOS = TimeUnit.MILLISECONDS.toNanos(STUCK_MILLIS);

    private final String port;
    private final Monitor monitor;
    private final FrameWriter writer;
    private final SharedLine line;
    private final LineClock clock;
    private final Monitor.Change<PortException> start;
    private Long toldNanos; // line.movedNanos() at the last warning that no command gets through

    /** @param start waits until a command may be sent to the board */
    CommandLoop(
            Monitor monitor,
            Transport transport,
            FrameWriter writer,
            SharedLine line,
            LineClock clock,
            Monitor.Change<PortException> start) {
        port = transport.name();
        this.monitor = monitor;
        this.writer = writer;
        this.line = line;
        this.clock = clock;
        this.start = start;
    }

    /** Queues a command. Writes the command at once if no wait is needed; see {@link Link#send(String, SendOptions)}. */
    Command submit(Frame frame, SendOptions options) {
        return submit(new Command(frame, options, clock.nanos()), options);
    }

    /** Like {@link #submit(Frame, SendOptions)}, for a command that changes the board's rules. */
    Command submit(CommandItem.Rule rule, SendOptions options) {
        return submit(new Command(rule, options, clock.nanos()), options);
    }

    private Command submit(Command command, SendOptions options) {
        String trouble = line.session()
                .vocabulary()
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
        } catch (PortException | RuntimeException | Error unforeseen) { // a transport may throw anything
            fail(command, unforeseen);
        }
        if (options.limitMillis() > 0 && !command.isOver()) {
            clock.schedule(
                    TimeUnit.MILLISECONDS.toNanos(options.limitMillis()), () -> fail(command, timeOver(command)));
        }
        return command;
    }

    /**
     * Queues a command. If the line is free, begins the command under the same lock and writes it on this thread. No other thread has to
     * wake.
     */
    private void queue(Command command) throws PortException {
        List<Command> replaced = new ArrayList<>();
        SharedLine.Outgoing frame = monitor.get(() -> {
            replaced.addAll(writer.submit(command));
            return writer.isWritableNow() ? line.nextAtOnce() : null;
        });
        replaced.forEach(earlier -> fail(earlier, replaced(earlier, command)));
        line.write(frame, 0);
    }

    void run() throws PortException {
        line.sends();
        while (true) {
            giveUpStuck();
            ask();
            try {
                line.serve(line::mustAskFirst, this::patienceEnds);
            } catch (RuntimeException | Error unforeseen) { // thrown by a transport
                LOG.log(System.Logger.Level.ERROR, "port " + port + " failed while commands were sent", unforeseen);
                line.abandon(unforeseen);
            }
        }
    }

    /** If the next command of version 1 needs a request before it, sends the request. */
    private void ask() throws PortException {
        if (!line.mustAskFirst()) {
            return;
        }
        try {
            start.run();
            line.hasAsked();
        } catch (PortTimeoutException
                | RuntimeException
                | Error trouble) { // a transport may throw anything; later commands still go out
            fail(writer.withdrawNext(), trouble);
        }
    }

    /** Returns the time at which waiting commands fail if no command gets through. */
    private long patienceEnds() {
        long now = clock.nanos();
        if (writer.head() == null) {
            return now + Monitor.FOREVER;
        }
        long moved = line.movedNanos();
        long since = now - moved >= STUCK_NANOS ? writer.waitingSince().orElse(now) : moved;
        return (since - moved > 0 ? since : moved) + STUCK_NANOS;
    }

    /** Fails commands without a time limit that have waited {@link #STUCK_NANOS} while no command got through. */
    private void giveUpStuck() {
        long now = clock.nanos();
        if (patienceEnds() - now > 0) {
            return;
        }
        long before = now - STUCK_NANOS;
        List<Command> stuck =
                writer.withdrawIf(command -> !command.hasTimeLimit() && command.submittedAt() - before <= 0);
        Long moved = line.movedNanos();
        if (!stuck.isEmpty() && !moved.equals(toldNanos)) {
            toldNanos = moved;
            LOG.log(
                    System.Logger.Level.WARNING,
                    "port " + port + ": commands that have waited for " + STUCK_MILLIS + " ms fail, "
                            + stuck.size() + " of them now: "
                            + line.board().noSession().orElseGet(writer::whyNoTime)
                            + "; this is not reported again until one gets through");
        }
        stuck.forEach(command -> fail(command, stuck(command)));
    }

    private PortTimeoutException stuck(Command command) {
        return line.board()
                .noSession()
                .map(why -> new PortTimeoutException(port, why))
                .orElseGet(() -> writer.noTime(command.frame().length(), STUCK_MILLIS));
    }

    void sendAndAwait(Frame frame, SendOptions options, int timeoutMillis) throws PortException {
        Command own = submit(frame, options);
        try {
            ask();
            long deadline = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
            while (!own.isOver()) {
                if (own.isWaiting() && deadline - clock.nanos() <= 0 && writer.withdraw(own)) {
                    fail(own, writer.noTime(frame.length(), timeoutMillis));
                    break;
                }
                ask();
                line.await(
                        () -> own.isOver() || line.mustAskFirst(),
                        own.isWaiting() ? deadline : clock.nanos() + STUCK_NANOS,
                        false);
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

    private PortException replaced(Command earlier, Command later) {
        return new CommandReplacedException(
                port,
                '"' + earlier.text() + "\" had not begun to go out through port " + port + " when \"" + later.text()
                        + "\" took its place, so it was not sent");
    }

    /** Handles a command whose time limit has ended. Withdraws the command if it has not begun. Returns the exception for the command. */
    private PortException timeOver(Command command) {
        String subject = '"' + command.text() + '"';
        return writer.withdraw(command)
                ? new CommandWithdrawnException(
                        port,
                        subject + " had not begun to go out through port " + port
                                + " when its time was over, so it was not sent; it waited for other commands, for an answer of "
                                + "the board, or for its start")
                : new ActionUnconfirmedException(
                        port,
                        subject + " was on its way through port " + port
                                + " when its time was over, and is not known to have arrived; it may have been carried out");
    }

    void failAll(String reason) {
        writer.withdrawIf(command -> true).forEach(command -> fail(command, new PortGoneException(port, reason)));
        line.abandon(new PortGoneException(port, reason));
    }

    private static void fail(Command command, Throwable failure) {
        if (command != null) {
            command.outcome().completeExceptionally(failure);
        }
    }
}
