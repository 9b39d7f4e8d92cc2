package javino;

import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;

/**
 * Takes the commands of a line from its queue to the board, on the threads that call {@link #run} and {@link #sendAndAwait}. Whichever of
 * these is free takes the next command, its own or another's. Outcomes are reported outside of any lock, on the thread that finds them
 * out; what their dependents throw ends no thread.
 */
final class CommandLoop {
    /** Returns when the board can be sent a command. */
    interface Start {
        void await() throws PortException;
    }

    private final String port;
    private final FrameWriter writer;
    private final Inbox inbox;
    private final RequestChannel channel;
    private final LineClock clock;
    private final Start start;
    private final CommandSender oneWay;
    private final CommandSender acknowledged;

    /** @param board a name that the board has whatever its port is called */
    CommandLoop(
            Transport transport,
            String board,
            FrameWriter writer,
            Inbox inbox,
            RequestChannel channel,
            LineClock clock,
            Start start) {
        port = transport.name();
        this.writer = writer;
        this.inbox = inbox;
        this.channel = channel;
        this.clock = clock;
        this.start = start;
        oneWay = new OneWaySender(writer, inbox, channel, clock);
        acknowledged = new StopAndWaitSender(port, board, inbox, writer, clock, transport.line());
    }

    /** Queues a command; see {@link Link#send(String, SendOptions)}. */
    Command submit(Frame frame, SendOptions options) {
        long limitNanos = TimeUnit.MILLISECONDS.toNanos(options.limitMillis());
        Command command = new Command(frame, options.urgent(), clock.nanos() + limitNanos, limitNanos > 0);
        command.outcome().whenComplete((done, failure) -> writer.reported());
        try {
            writer.submit(command);
        } catch (PortGoneException gone) {
            fail(command, gone);
        }
        if (limitNanos > 0) {
            clock.schedule(limitNanos, () -> fail(command, timeOver(command)));
        }
        return command;
    }

    /** Sends commands until the line ends or the thread is interrupted. */
    void run() throws PortException {
        while (writer.awaitWork(null, 0)) {
            long deadline = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(CommandSender.MAX_WRITE_MILLIS);
            sendNext(deadline);
            if (clock.nanos() - deadline > 0) {
                failStuck();
            }
        }
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
                if (own.isWaiting() && deadline - clock.nanos() < 0 && writer.withdraw(own)) {
                    fail(own, writer.noTime(frame, timeoutMillis));
                } else if (writer.awaitWork(own, deadline)) {
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

    /** Sends the command whose turn is next, if it comes by {@code deadline}. */
    private void sendNext(long deadline) throws PortException {
        try {
            if (channel.mustAsk()) {
                start.await();
            }
        } catch (RuntimeException | LinkageError unforeseen) { // a transport's
            fail(writer.withdrawNext(), unforeseen);
        }
        Command command = writer.awaitCommand(deadline);
        if (command == null) {
            return;
        }
        Throwable failure = transmit(command);
        writer.finish();
        if (failure == null) {
            command.outcome().complete(null);
        } else {
            fail(command, failure);
        }
        if (failure instanceof PortGoneException gone) {
            throw gone;
        }
    }

    private Throwable transmit(Command command) {
        try {
            (channel.protocol() == Protocol.V2 ? acknowledged : oneWay).send(command);
            return null;
        } catch (PortTimeoutException trouble) {
            return goneOr(trouble);
        } catch (ActionUnconfirmedException trouble) {
            return command.nanosLeft(clock.nanos(), 1) > 0 ? trouble : timeOver(command);
        } catch (PortException | RuntimeException | LinkageError trouble) {
            return trouble; // the commands behind it must go on, whatever a transport throws
        }
    }

    /** Why the line is gone if it is, which a write that takes too long may be the first to show; else {@code trouble}. */
    private PortException goneOr(PortTimeoutException trouble) {
        try {
            inbox.look();
            return trouble;
        } catch (PortException gone) {
            return gone;
        }
    }

    private void failStuck() {
        Command stuck = writer.withdrawNext();
        if (stuck != null) {
            fail(stuck, writer.noTime(stuck.frame(), CommandSender.MAX_WRITE_MILLIS));
        }
    }

    /** Withdraws a command whose time is over, if it has not begun to go out. */
    private PortException timeOver(Command command) {
        String subject = '"' + command.frame().text() + '"';
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

    /** Fails the commands that wait, on a line that is gone for {@code reason}. */
    void failAll(String reason) {
        for (Command command : writer.withdrawAll()) {
            fail(command, new PortGoneException(port, reason));
        }
    }

    private static void fail(Command command, Throwable failure) {
        if (command != null) {
            command.outcome().completeExceptionally(failure);
        }
    }
}
