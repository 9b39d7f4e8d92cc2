package javino;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Lock;
import java.util.function.BooleanSupplier;

/**
 * An open port that one owner exchanges messages through.
 *
 * <p>Methods are safe on any thread. Typically one thread calls {@link #request} or {@link #listen}, which read the line on that thread and
 * take turns with each other, while another calls {@link #send}; a request waits only for messages whose sending was called before it.
 * Frames go out as {@link LinkSettings} say: at the line's pace, and no faster than a version 1 board can handle them.
 *
 * <p>Opening a port resets most boards, which then take a second or two to start. A link finds out by asking: until the first message has
 * come from the board, or {@link LinkSettings#bootMillis()} since opening have passed, a request is repeated every 250 ms (or its own time
 * limit, if that is shorter), and the first {@link #send} asks for percepts and drops the answer. A board that runs answers at once.
 *
 * <p>Unless {@link LinkSettings#protocol()} says which version of the protocol is spoken, the link finds that out as well, and stays with it:
 * what is asked first is asked in version 2, and if there is no answer within 0.4 s, in version 1. A version 1 board does not
 * understand the former and forgets it in that time; no frame of version 1 goes out before. From a board of version 2 messages come
 * whole or not at all, and {@link #send} knows what became of an action.
 *
 * <p>Once the device has gone, or the link is closed, every call throws {@link PortGoneException}, those that wait promptly, and the port is
 * free for another link. An interrupted call throws {@link PortInterruptedException} and the link stays usable.
 */
public final class Link implements AutoCloseable {
    private static final long MAX_WAIT_NANOS = 600_000_000L;
    /** How long the device may be gone before it is noticed while a long message leaves. */
    private static final long WATCH_NANOS = 250_000_000L;

    private final Lock ending;
    private final Lock reading;
    private final Transport transport;
    private final LinkSettings settings;
    private final PortOwners.Claim claim;
    private final LineClock clock;
    private final FrameWriter writer;
    private final Inbox inbox;
    private final RequestChannel channel; // used by who holds reading
    private final StopAndWaitSender sender;

    Link(Transport transport, LinkSettings settings, PortOwners.Claim claim, LineClock clock) {
        this.transport = transport;
        this.settings = settings;
        this.claim = claim;
        this.clock = clock;
        ending = clock.newLock(false);
        reading = clock.newLock(true); // fair: a sender that must wait for readiness gets its turn too
        writer = new FrameWriter(transport, new Pacer(settings, clock.nanos()), clock);
        inbox = new Inbox(transport, clock, writer::received, settings.protocol(), settings.messageLimit());
        channel = new RequestChannel(inbox, writer, clock, settings);
        sender = new StopAndWaitSender(transport.name(), inbox, writer, clock, settings.line());
    }

    /**
     * Opens a port.
     *
     * @param port as {@link Transports#open} takes it: {@code ttyACM0}, {@code /dev/pts/3}, {@code COM8}, {@code sim:robot}
     * @param owner who has the port from now on, in words that {@link PortBusyException} can tell others
     * @throws NoSuchPortException if there is no such port
     * @throws PortBusyException if another link or program has it open
     * @throws PortPermissionException if this user may not open it
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
     * A link on a line that is open already, in the time of {@code clock}: for tests, and for lines that {@link Transports} does not know.
     * It has no owner, so {@link #ownerOf} knows nothing of it.
     *
     * @param transport closed with the link; its waits go by the same clock
     * @param settings whose rate should be that of the line
     */
    public static Link over(Transport transport, LinkSettings settings, LineClock clock) {
        return new Link(transport, settings, PortOwners.nobodys(transport.name()), clock);
    }

    /** The owner of a port that a link of this program has open, under whatever name of that port. */
    public static Optional<String> ownerOf(String port) {
        return PortOwners.ownerOf(port);
    }

    /** The port's name, as it was given. */
    public String port() {
        return transport.name();
    }

    /** Whether the far end may go without this end being told, see {@link Transport#mayVanish()}. */
    public boolean mayVanish() {
        return transport.mayVanish();
    }

    /** The settings it was opened with. */
    public LinkSettings settings() {
        return settings;
    }

    /** The version that is spoken; {@link Protocol#AUTO} while it has not been found out. */
    public Protocol protocol() {
        return channel.protocol();
    }

    /** Frames of version 2 that have arrived with a wrong checksum and were dropped. */
    public long corruptFrames() {
        return inbox.corrupt();
    }

    /** Whether it can be used: it was not closed, and no call has found its device gone. */
    public boolean isOpen() {
        return writer.hasLine();
    }

    /**
     * Sends a request and returns its answer. What was received before it is dropped, as the answer to an earlier one. After a request whose
     * answer did not come in time, the next takes the last message that comes before the line falls silent.
     *
     * @param timeoutMillis milliseconds, at least 1, that the request waits at most for its turn on the line, and that the board then has to
     *     answer, counted from the request's last byte. After a missed answer the line is given as long again to fall silent; while the board
     *     may be starting the request is repeated until it must have started
     * @throws PortTimeoutException if no answer came
     * @throws IllegalArgumentException if the message does not fit into a frame, see {@link Frame#of(String)}
     */
    public String request(String message, int timeoutMillis) throws PortException {
        Frame request = Frame.of(message);
        requireTime(timeoutMillis);
        return reading(() -> {
            Message answer = channel.request(request, timeoutMillis);
            if (answer == null) {
                throw new PortTimeoutException(port(), "port " + port() + " gave no answer to \"" + message + "\" within " + timeoutMillis
                        + " ms; " + transport.doubt());
            }
            return answer.text();
        });
    }

    /**
     * Sends an action. To a version 1 board: returns when its last byte has left by the line's rate (if the link is not paced: when the
     * driver has it). To a version 2 board: returns when the board has said that it has acted; until then the action is sent up to four times,
     * which the board takes for one, and it is waited for up to some five seconds, less if the board is known to be quick.
     *
     * @param timeoutMillis milliseconds, at least 1, that it waits at most for its turn on the line, after the board has had time to start
     * @throws ActionRefusedException if a version 2 board does not know the action, or not with these arguments
     * @throws ActionUnconfirmedException if a version 2 board has not said that it acted; it may have
     * @throws PortTimeoutException if its turn did not come, and then nothing was sent; or if the driver did not take it, and then some of it
     *     may have been
     * @throws IllegalArgumentException if the message does not fit into a frame, see {@link Frame#of(String)}
     */
    public void send(String message, int timeoutMillis) throws PortException {
        send(message, timeoutMillis, () -> true);
    }

    /**
     * As {@link #send(String, int)}, of an action that may be given up until its turn has come.
     *
     * @param goes asked once, by the calling thread, right before the first byte is written: whether the action is still to be sent
     * @return false if it was not, and then nothing was sent
     */
    public boolean send(String message, int timeoutMillis, BooleanSupplier goes) throws PortException {
        Frame action = Frame.of(message);
        requireTime(timeoutMillis);
        try {
            return noticing(() -> {
                if (channel.mustAsk()) {
                    awaitStart();
                }
                if (channel.protocol() == Protocol.V2) {
                    sender.deliver(action, timeoutMillis, () -> requireWanted(goes));
                } else {
                    awaitSent(writer.write(FrameWriter.Kind.ACTION, action, timeoutMillis, () -> {
                        channel.awaitGap();
                        requireWanted(goes);
                        inbox.sends(action);
                    }));
                }
                return true;
            });
        } catch (GivenUpException e) {
            return false;
        }
    }

    /** Waits until the last byte has left, which takes seconds on a slow line, and watches it: who would read it may be waiting for its turn. */
    private void awaitSent(long nanos) throws PortException {
        while (nanos - clock.nanos() > WATCH_NANOS) {
            writer.awaitTime(clock.nanos() + WATCH_NANOS);
            inbox.look();
        }
        writer.awaitTime(nanos);
    }

    private void requireWanted(BooleanSupplier goes) throws GivenUpException {
        if (!goes.getAsBoolean()) {
            throw new GivenUpException(port());
        }
    }

    /**
     * Waits for a message that the board sends of its own accord. If several are waiting, the newest is taken and the others are dropped.
     *
     * @param timeoutMillis milliseconds to wait at most, at least 1
     * @throws PortTimeoutException if none came
     */
    public String listen(int timeoutMillis) throws PortException {
        requireTime(timeoutMillis);
        return reading(() -> {
            Message message = channel.listen(timeoutMillis);
            if (message == null) {
                throw new PortTimeoutException(port(), "port " + port() + " sent no message within " + timeoutMillis + " ms");
            }
            return message.text();
        });
    }

    /**
     * Finds out whether the device is still there, for who does not read the line all the time. Does not wait, and takes no message from who
     * does.
     *
     * @throws PortGoneException if it is not
     */
    public void check() throws PortException {
        noticing(() -> {
            inbox.look();
            return null;
        });
    }

    /** Closes the port and gives it back. Calls that wait on this link throw {@link PortGoneException}. Idempotent. */
    @Override
    public void close() {
        end("port " + port() + " is gone: it was closed");
    }

    private void end(String why) {
        writer.end(why); // wakes who waits for the line
        ending.lock(); // a second caller returns when the port is really free
        try {
            transport.close();
            claim.release();
        } finally {
            ending.unlock();
        }
    }

    /** Returns when the board has said something, or must have started. */
    private void awaitStart() throws PortException {
        try {
            if (!reading.tryLock(Math.max(channel.nanosUntilStarted(), MAX_WAIT_NANOS), TimeUnit.NANOSECONDS)) {
                return; // another call waited for it meanwhile, or listens for so long that the action must not wait for it
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

    /** Work on an open line. */
    private interface LineWork<T> {
        T run() throws PortException;
    }

    /** Does work that reads the line, in turn with others that read it. */
    private <T> T reading(LineWork<T> work) throws PortException {
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

    /** Does work, and gives the port back if the line turns out to be gone. */
    private <T> T noticing(LineWork<T> work) throws PortException {
        try {
            writer.requireLine();
            return lookingAtLast(work);
        } catch (PortGoneException e) {
            end(e.getMessage());
            throw e;
        }
    }

    /** Does work, and looks at the line if its time is over: who has waited for a turn on the line has not read it. */
    private <T> T lookingAtLast(LineWork<T> work) throws PortException {
        try {
            return work.run();
        } catch (PortTimeoutException e) {
            inbox.look();
            throw e;
        }
    }

    private PortInterruptedException interrupted() {
        return PortInterruptedException.remarking(port());
    }
}
