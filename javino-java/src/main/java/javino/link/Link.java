package javino.link;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Lock;
import java.util.function.Supplier;
import javino.ActionRefusedException;
import javino.ActionUnconfirmedException;
import javino.CommandReplacedException;
import javino.CommandWithdrawnException;
import javino.Frame;
import javino.LineClock;
import javino.NoSuchPortException;
import javino.PerceptDescription;
import javino.PerceptsRequest;
import javino.PortBusyException;
import javino.PortException;
import javino.PortFaultException;
import javino.PortGoneException;
import javino.PortInterruptedException;
import javino.PortPermissionException;
import javino.PortTimeoutException;
import javino.Protocol;
import javino.Transport;
import javino.Transports;
import javino.wire.BoardAction;
import javino.wire.CommandItem;

/**
 * An open port through which one owner exchanges messages with a board.
 * <p>Methods are safe on any thread. {@link #request} and {@link #listen} read the line on the calling thread, one call after the other.
 * {@link #send} never waits: it queues a command. A thread in {@link #writeCommandsUntilClosed} sends the command. {@link LinkSettings}
 * set the pace of frames. By default no frame goes out faster than the line or a version 1 board can take it.
 * <p>Opening a port resets most boards, which then take a second or two to start. A link therefore asks the board until its first message
 * has come, or until {@link LinkSettings#bootMillis()} have passed since opening. Until then, the link repeats a request every 250 ms, or
 * after the request's own time limit if that is shorter. The first {@link #send} asks for percepts and drops the answer. A running board
 * answers at once.
 * <p>If {@link LinkSettings#protocol()} is {@link Protocol#AUTO}, the link finds out the board's version. The link sends HELLO of version
 * 2 twice. After each HELLO the link waits for 60 ms, or for 20 byte times if 20 byte times are longer. If no answer comes, the link asks
 * in version 1. Version 1 boards ignore HELLO, and get no frame of version 1 during these waits. A message from a version 2 board arrives
 * whole or not at all. In version 2 the future of {@link #send} tells the outcome of an action.
 * <p>If the device has gone or the link is closed, every call soon throws {@link PortGoneException}, even a waiting call. The port is
 * then free for another link. An interrupted call throws {@link PortInterruptedException}, and the link stays usable.
 */
public final class Link implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(Link.class.getName());
    private static final long MAX_WAIT_NANOS = TimeUnit.MILLISECONDS.toNanos(600);
    /**
     * After an answer or an outcome, no request goes out for a request's time divided by this number. The agent may send commands in this
     * pause.
     */
    private static final int GRACE_DIVISOR = 8;

    private static final int REQUEST_BYTES = Frame.of(PerceptsRequest.ALL).length();

    private final Lock ending;
    private final Lock reading;
    private final Transport transport;
    private final LinkSettings settings;
    private final PortOwners.Claim claim;
    private final LineClock clock;
    private final FrameWriter writer;
    private final SharedLine line;
    private final BoardStatus board;
    private final RequestChannel channel; // used only by the thread that holds the lock reading
    private final CommandLoop commands;
    private volatile long exchangeNanos; // duration of the last exchange
    private volatile long answeredNanos; // end of the last exchange

    Link(Transport transport, LinkSettings settings, PortOwners.Claim claim, LineClock clock) {
        this.transport = transport;
        this.settings = settings;
        this.claim = claim;
        this.clock = clock;
        ending = clock.newLock(false);
        reading = clock.newLock(true); // fair: a sender that waits for the board's start also gets the lock
        Monitor monitor = new Monitor(clock, transport.name());
        writer = new FrameWriter(monitor, transport, new Pacer(settings, clock.nanos()), clock);
        line = new SharedLine(monitor, transport, clock, writer, settings);
        board = line.board();
        channel = new RequestChannel(line, writer, clock, settings);
        answeredNanos = clock.nanos();
        commands = new CommandLoop(monitor, transport, writer, line, clock, this::awaitStart);
    }

    /**
     * Opens a port. If the present owner is {@linkplain #leave leaving} the port, waits until the port is free.
     *
     * @param port the port's name, such as {@code ttyACM0}, {@code /dev/pts/3}, {@code COM8}, {@code sim:robot}
     * @param owner a name for the owner, which {@link PortBusyException} shows
     * @throws NoSuchPortException if there is no such port
     * @throws PortBusyException if another link or program has the port open
     * @throws PortPermissionException if this user may not open the port
     * @throws PortFaultException if the driver refuses for another reason
     */
    public static Link open(String port, LinkSettings settings, String owner) throws PortException {
        PortOwners.Claim claim = PortOwners.claim(port, owner);
        boolean opened = false;
        try {
            Link link = new Link(Transports.open(port, settings.line()), settings, claim, LineClock.system());
            opened = true;
            return link;
        } finally {
            if (!opened) {
                claim.release();
            }
        }
    }

    /**
     * Creates a link on an open line, for tests and for lines that {@link Transports} does not know. {@link #ownerOf} does not find the
     * link.
     *
     * @param transport the open line, whose waits use {@code clock}. The link closes the line
     * @param settings the settings, with the line's rate
     */
    public static Link over(Transport transport, LinkSettings settings, LineClock clock) {
        return new Link(transport, settings, PortOwners.nobodys(transport.name()), clock);
    }

    /** Returns the owner of {@code port}, under any of the port's names. Returns empty if no link of this program has the port open. */
    public static Optional<String> ownerOf(String port) {
        return PortOwners.ownerOf(port);
    }

    /** Returns the port's name, as it was given. */
    public String port() {
        return transport.name();
    }

    /** Returns whether the far end may vanish without an error, see {@link Transport#mayVanish()}. */
    public boolean mayVanish() {
        return transport.mayVanish();
    }

    /** The settings with which the link was opened. */
    public LinkSettings settings() {
        return settings;
    }

    /** Returns the version that is spoken. Returns {@link Protocol#AUTO} if the version is not known yet. */
    public Protocol protocol() {
        return board.protocol();
    }

    /**
     * Returns the board's registered actions, by number. Empty while the actions are not known, and in version 1. Safe on any thread.
     * Does not wait.
     */
    public Optional<List<BoardAction>> vocabulary() {
        return line.session().vocabulary();
    }

    /**
     * Asks the board for the kinds of its percepts. First waits until no other request is in progress. Leaves out and logs kinds that
     * cannot be read.
     *
     * @param timeoutMillis milliseconds that the board has to answer, at least 1
     * @return the description; it is empty if the board describes no percepts, or is not known to speak version 2
     * @throws PortTimeoutException if the board speaks version 2 and gave no answer
     */
    public PerceptDescription perceptDescription(int timeoutMillis) throws PortException {
        requireTime(timeoutMillis);
        Reply answer = reading(() -> {
            Reply described = channel.requestKinds(timeoutMillis);
            if (described == null && board.speaks2()) {
                throw new PortTimeoutException(
                        port(),
                        "the board on port " + port() + " did not describe its percepts within " + timeoutMillis
                                + " ms");
            }
            return described;
        });
        if (answer == null) {
            return new PerceptDescription(List.of(), List.of());
        }
        PerceptDescription description = PerceptDescription.read(answer.text());
        List<String> problems = description.problems();
        if (!problems.isEmpty()) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "port " + port() + ": kinds of percepts that the board describes are left out, " + problems.size()
                            + " in all: " + problems.get(0));
        }
        return description;
    }

    /**
     * Returns the number of actions that the board has no room for. The board refuses these actions. 0 also means that the number is not
     * known yet.
     */
    public int actionsLost() {
        return line.session().actionsLost();
    }

    /**
     * Sets the listener for the board's own reports, in place of the present listener. If there is a session, calls
     * {@link BoardListener#sessionBegan} on the calling thread before it returns.
     */
    public void onBoardEvents(BoardListener listener) {
        line.session().onBoardEvents(Objects.requireNonNull(listener, "listener"));
    }

    /** Returns the number of frames of version 2 that were dropped for a wrong checksum. */
    public long corruptFrames() {
        return line.inbox().corrupt();
    }

    /** Returns whether this link can be used: it is not closed, and no call has found its device gone. */
    public boolean isOpen() {
        return writer.hasLine();
    }

    /**
     * Sends a request and returns its answer. Drops messages that came before the request, because they answer earlier requests. If an
     * answer does not come in time, the next request first waits for a silence of the line. The next request then returns the last
     * message before the silence.
     *
     * @param timeoutMillis milliseconds, at least 1, to wait at most for other frames on the line. The board gets this time again for its
     *     answer, counted from the request's last byte. After a missed answer, the wait for silence takes at most this time again. The
     *     request is repeated while the board may be starting
     * @throws PortTimeoutException if no answer came
     * @throws IllegalArgumentException if the message does not fit into a frame, see {@link Frame#of(String)}
     */
    public Reply request(String message, int timeoutMillis) throws PortException {
        Frame request = Frame.of(message);
        requireTime(timeoutMillis);
        if (board.protocol() == Protocol.V1 && !board.mustAsk()) {
            writer.awaitCommandsSoFar(TimeUnit.MILLISECONDS.toNanos(timeoutMillis));
        }
        return isCommand(message) ? answerToCommand(message, timeoutMillis) : exchange(request, timeoutMillis);
    }

    /**
     * Like {@link #request(String, int)}, for a caller that asks repeatedly. A command behind a request must wait for a whole exchange.
     * This method therefore first waits for the commands submitted before the call, then for the commands submitted during that wait.
     * Commands cannot starve requests: each of the two waits takes at most the time of the last exchange, or the interval if that is
     * longer.
     *
     * @param message returns the request; called when the request is about to go out
     * @param intervalMillis milliseconds between requests
     */
    public Reply request(Supplier<String> message, int timeoutMillis, int intervalMillis) throws PortException {
        requireTime(timeoutMillis);
        long limit = Math.max(TimeUnit.MILLISECONDS.toNanos(intervalMillis), exchangeNanos);
        long grace = settings.line().byteNanos() * REQUEST_BYTES / GRACE_DIVISOR;
        noticing(() -> {
            giveWay(limit);
            long outcome = writer.outcomeNanos();
            writer.awaitTime((outcome - answeredNanos > 0 ? outcome : answeredNanos) + grace);
            giveWay(limit);
            return null;
        });
        long start = clock.nanos();
        try {
            return exchange(Frame.of(message.get()), timeoutMillis);
        } finally {
            answeredNanos = clock.nanos();
            exchangeNanos = answeredNanos - start;
        }
    }

    /**
     * Waits at most {@code nanos} until the commands submitted so far have ended. In version 2, the wait ends when the commands have
     * begun, because both directions send at once.
     */
    private void giveWay(long nanos) throws PortException {
        if (board.speaks2()) {
            line.await(writer.commandsSoFarHaveBegun(), clock.nanos() + nanos, false);
        } else {
            writer.awaitCommandsSoFar(nanos);
        }
    }

    /** Returns whether the board is known to speak version 2 and would treat {@code message} as a command. */
    private boolean isCommand(String message) {
        return board.speaks2() && !PerceptsRequest.isIn(message);
    }

    /**
     * Sends a message other than a request for percepts to a version 2 board. Version 2 treats the message as a command. The board's next
     * message is the answer to the command.
     */
    private Reply answerToCommand(String message, int timeoutMillis) throws PortException {
        line.session().takeHeard(); // drops earlier messages
        sendAndAwait(message, timeoutMillis);
        return listen(
                timeoutMillis,
                noAnswerTo(message),
                "the board has taken it as a command: does the sketch send a message behind it?");
    }

    private static String noAnswerTo(String message) {
        return "gave no answer to \"" + message + "\"";
    }

    private Reply exchange(Frame request, int timeoutMillis) throws PortException {
        Reply answered = reading(() -> {
            Reply answer = channel.request(request, timeoutMillis);
            if (answer == null && !isCommand(request.text())) {
                throw silence(noAnswerTo(request.text()), timeoutMillis, transport.doubt());
            }
            return answer;
        });
        // null: the board turned out to speak version 2, which treats this request as a command
        return answered == null ? answerToCommand(request.text(), timeoutMillis) : answered;
    }

    /** Returns the likely reason for a silence: no possible session, stray bytes, or else {@code usual}. */
    private String doubt(String usual) {
        StrayBytes stray = strayBytes();
        return board.noSession().orElseGet(() -> stray.count() == 0 ? usual : stray.inWords());
    }

    /** Returns the bytes since the last message. Safe on any thread. Does not wait. */
    public StrayBytes strayBytes() {
        return line.inbox().strayBytes();
    }

    /**
     * Queues a command and returns at once. A thread in {@link #writeCommandsUntilClosed} sends urgent commands before others.
     *
     * <p>The thread that learns the outcome completes the future and holds no lock. In version 1 the outcome is known when the last byte
     * has left by the line's rate. If the link is not paced, the outcome is known when the driver has the last byte. In version 2 the
     * outcome is known when the board has acted. Until then the link repeats the command, and the board acts only once. After four
     * repetitions and 2 s without any frame from the board, the link gives the command up.
     *
     * <p>The future fails with
     * <ul>
     *   <li>{@link ActionRefusedException} if the board does not know the command, or not with these arguments;
     *   <li>{@link ActionUnconfirmedException} if it is unknown whether the board has acted;
     *   <li>{@link CommandWithdrawnException} if the command's time limit ended before it began to go out;
     *   <li>{@link CommandReplacedException} if a later command replaced it;
     *   <li>{@link PortTimeoutException} if the line had no time for it, or the driver did not take it;
     *   <li>{@link PortGoneException} if the line is gone;
     *   <li>any exception that a transport throws.
     * </ul>
     * If a caller completes or cancels the future before the command has begun to go out, the command is not sent.
     *
     * @throws IllegalArgumentException if the message does not fit into a frame, see {@link Frame#ofCommand(String)}
     */
    public CompletableFuture<Void> send(String command, SendOptions options) {
        return commands.submit(Frame.ofCommand(command), options).outcome();
    }

    /**
     * Like {@link #send}, for a command that sets or removes critical rules of the board, see {@link javino.wire.BoardRule}. A text
     * command cannot change rules. If the board speaks version 1, the future fails with {@link ActionRefusedException}.
     */
    public CompletableFuture<Void> sendRule(CommandItem.Rule rule, SendOptions options) {
        return commands.submit(rule, options).outcome();
    }

    /**
     * Sends present and future queued commands to the board until an exception ends this call. Call this method on a thread of its own,
     * because it does not return when the queue is empty.
     *
     * <pre>{@code
     * new Thread(() -> {
     *     try {
     *         link.writeCommandsUntilClosed();
     *     } catch (PortException ended) {
     *         System.err.println(ended.getMessage());
     *     }
     * }).start();
     * link.send("speed(120)", SendOptions.defaults()).join();
     * }</pre>
     *
     * @throws PortGoneException if the link is closed, or its device has gone
     * @throws PortInterruptedException if the thread is interrupted
     */
    public void writeCommandsUntilClosed() throws PortException {
        noticing(() -> {
            commands.run();
            return null;
        });
    }

    /**
     * Like {@link #send}, but on the calling thread. The calling thread also sends the commands before this one, if no other thread does.
     * Returns when the command has arrived.
     *
     * @param timeoutMillis milliseconds, at least 1, to wait at most for other frames, after the board has had time to start
     * @throws PortTimeoutException if other frames took all the time, so nothing was sent, or if the driver did not take the whole frame:
     *     some bytes may have gone out
     * @throws PortException with which the future of {@link #send} fails
     */
    public void sendAndAwait(String command, int timeoutMillis) throws PortException {
        Frame frame = Frame.ofCommand(command);
        requireTime(timeoutMillis);
        sendAndAwait(frame, SendOptions.defaults(), timeoutMillis);
    }

    /** Like {@link #sendAndAwait(String, int)}, with options. The command waits at most five seconds for the line. */
    public void sendAndAwait(String command, SendOptions options) throws PortException {
        sendAndAwait(Frame.ofCommand(command), options, CommandLoop.STUCK_MILLIS);
    }

    private void sendAndAwait(Frame frame, SendOptions options, int timeoutMillis) throws PortException {
        noticing(() -> {
            commands.sendAndAwait(frame, options, timeoutMillis);
            return null;
        });
    }

    /**
     * Waits for a message that the board sends on its own. Returns the newest message, and drops older ones.
     *
     * @param timeoutMillis milliseconds to wait at most, at least 1
     * @throws PortTimeoutException if no message came
     */
    public Reply listen(int timeoutMillis) throws PortException {
        return listen(timeoutMillis, "sent no message", "does the board send percepts unasked?");
    }

    private Reply listen(int timeoutMillis, String missed, String usualDoubt) throws PortException {
        requireTime(timeoutMillis);
        return reading(() -> {
            Reply message = channel.listen(timeoutMillis);
            if (message == null) {
                throw silence(missed, timeoutMillis, usualDoubt);
            }
            return message;
        });
    }

    private PortTimeoutException silence(String missed, int timeoutMillis, String usualDoubt) {
        return new PortTimeoutException(
                port(), "port " + port() + " " + missed + " within " + timeoutMillis + " ms; " + doubt(usualDoubt));
    }

    /**
     * Reads the line for {@code timeoutMillis}, for a pause between requests. Passes {@linkplain #onBoardEvents the board's reports} on.
     * Keeps messages for {@link #listen}. Throws if the device has gone.
     *
     * @param timeoutMillis milliseconds, at least 1
     */
    public void watch(int timeoutMillis) throws PortException {
        requireTime(timeoutMillis);
        reading(() -> {
            channel.watch(clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis));
            return null;
        });
    }

    /**
     * Checks whether the device is still there. Does not wait, and takes no message from a reading thread.
     *
     * @throws PortGoneException if the device has gone
     */
    public void check() throws PortException {
        noticing(() -> {
            line.inbox().look();
            return null;
        });
    }

    /** Closes the port and releases it. Waiting calls throw {@link PortGoneException}. Idempotent. */
    @Override
    public void close() {
        end("port " + port() + " is gone: it was closed");
    }

    /** Announces {@link #close}. From now on an {@link #open} of this port waits a while for the close. Does not wait. */
    public void leave() {
        claim.leave();
    }

    private void end(String why) {
        claim.leave();
        writer.end(why); // wakes waiting threads
        commands.failAll(why);
        ending.lock(); // a second caller returns only after the port is free
        try {
            transport.close();
            claim.release();
        } finally {
            ending.unlock();
        }
    }

    /** Waits until the board has sent something, or must have started. */
    private void awaitStart() throws PortException {
        if (channel.sayHelloToListener()) {
            return;
        }
        try {
            if (!reading.tryLock(Math.max(board.nanosToStart(), MAX_WAIT_NANOS), TimeUnit.NANOSECONDS)) {
                // another call reads: it also waits for the start, or listens for a long time
                return;
            }
        } catch (InterruptedException e) {
            throw interrupted();
        }
        try {
            channel.awaitStart();
        } finally {
            reading.unlock();
        }
    }

    private static void requireTime(int timeoutMillis) {
        if (timeoutMillis < 1) {
            throw new IllegalArgumentException("a time limit is at least 1 ms, but " + timeoutMillis + " was given");
        }
    }

    /** Does work that reads the line. Only one thread at a time does such work. */
    private <T> T reading(Monitor.Work<T, PortException> work) throws PortException {
        try {
            reading.lockInterruptibly();
        } catch (InterruptedException e) {
            throw interrupted();
        }
        try {
            return noticing(work);
        } finally {
            reading.unlock();
        }
    }

    /** Does work. If the line turns out to be gone, releases the port. */
    private <T> T noticing(Monitor.Work<T, PortException> work) throws PortException {
        try {
            writer.requireLine();
            return lookingAtLast(work);
        } catch (PortGoneException e) {
            end(e.getMessage());
            throw e;
        } finally {
            line.report();
        }
    }

    /** Does work. After a timeout reads the line once: a thread that only waited does not know whether the line is gone. */
    private <T> T lookingAtLast(Monitor.Work<T, PortException> work) throws PortException {
        try {
            return work.run();
        } catch (PortTimeoutException e) {
            line.inbox().look();
            throw e;
        }
    }

    private PortInterruptedException interrupted() {
        return PortInterruptedException.remarking(port());
    }
}
