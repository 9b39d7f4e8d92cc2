package javino;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;

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
 * <p>Once the device has gone, or the link is closed, every call throws {@link PortGoneException}, those that wait promptly, and the port is
 * free for another link. An interrupted call throws {@link PortInterruptedException} and the link stays usable.
 */
public final class Link implements AutoCloseable {
    /** What is asked of a board to find out whether it runs: every board answers it and none acts on it. */
    private static final String READINESS_REQUEST = "getPercepts";

    private static final long NANOS_PER_MILLI = 1_000_000L;
    private static final int REPEAT_MILLIS = 250;
    private static final long QUIET_NANOS = LineSchedule.QUIET_MILLIS * NANOS_PER_MILLI;

    private final ReentrantLock reading = new ReentrantLock(true); // fair: a sender that must wait for readiness gets its turn too
    private final Transport transport;
    private final LinkSettings settings;
    private final PortOwners.Claim claim;
    private final LineClock clock;
    private final FrameWriter writer;
    private final Inbox inbox; // guarded by reading, as is history
    private final AnswerHistory history = new AnswerHistory();
    private final long bootedAt; // when a board that has not answered is taken to have started
    private volatile boolean ready;

    Link(Transport transport, LinkSettings settings, PortOwners.Claim claim, LineClock clock) {
        long now = clock.nanos();
        this.transport = transport;
        this.settings = settings;
        this.claim = claim;
        this.clock = clock;
        writer = new FrameWriter(transport, new LineSchedule(settings, now), clock);
        inbox = new Inbox(transport, clock, writer::received);
        bootedAt = now + settings.bootMillis() * NANOS_PER_MILLI;
        ready = settings.bootMillis() == 0;
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

    /** The owner of a port that a link of this program has open, under whatever name of that port. */
    public static Optional<String> ownerOf(String port) {
        return PortOwners.ownerOf(port);
    }

    /** The port's name, as it was given. */
    public String port() {
        return transport.name();
    }

    /** The settings it was opened with. */
    public LinkSettings settings() {
        return settings;
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
            Frame answer = mayBeStarting() ? firstExchange(request, timeoutMillis) : exchange(request, timeoutMillis);
            if (answer == null) {
                throw new PortTimeoutException(port(), "port " + port() + " gave no answer to \"" + message + "\" within " + timeoutMillis
                        + " ms; does the board run a Javino sketch at " + settings.baud() + " baud?");
            }
            return answer.text();
        });
    }

    /**
     * Sends an action and returns when its last byte has left by the line's rate (if the link is not paced: when the driver has it).
     *
     * @param timeoutMillis milliseconds, at least 1, that it waits at most for its turn on the line, after the board has had time to start
     * @throws PortTimeoutException if its turn did not come; then nothing was sent
     * @throws IllegalArgumentException if the message does not fit into a frame, see {@link Frame#of(String)}
     */
    public void send(String message, int timeoutMillis) throws PortException {
        Frame action = Frame.of(message);
        requireTime(timeoutMillis);
        noticing(() -> {
            if (mayBeStarting()) {
                awaitReadiness();
            }
            writer.awaitTime(writer.write(FrameWriter.Kind.ACTION, action, timeoutMillis, () -> { }));
            return null;
        });
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
            Frame message = inbox.next(clock.nanos() + timeoutMillis * NANOS_PER_MILLI);
            if (message == null) {
                throw new PortTimeoutException(port(), "port " + port() + " sent no message within " + timeoutMillis + " ms");
            }
            ready = true;
            return newest(message).text();
        });
    }

    /** Closes the port and gives it back. Calls that wait on this link throw {@link PortGoneException}. Idempotent. */
    @Override
    public void close() {
        end("port " + port() + " is gone: it was closed");
    }

    private void end(String why) {
        writer.end(why);
        transport.close();
        claim.release();
    }

    private boolean mayBeStarting() {
        return !ready && bootedAt - clock.nanos() > 0;
    }

    /** Returns when the board has answered, or must have started. */
    private void awaitReadiness() throws PortException {
        try {
            if (!reading.tryLock(bootedAt - clock.nanos(), TimeUnit.NANOSECONDS)) {
                return;
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new PortInterruptedException(port());
        }
        try {
            if (mayBeStarting()) {
                exchangeUntil(bootedAt, Frame.of(READINESS_REQUEST), REPEAT_MILLIS);
            }
        } finally {
            reading.unlock();
        }
    }

    /** The first exchange with a board that may be starting: goes on for its time limit at least; null: no answer. */
    private Frame firstExchange(Frame request, int timeoutMillis) throws PortException {
        long timeoutNanos = timeoutMillis * NANOS_PER_MILLI;
        long now = clock.nanos();
        return exchangeUntil(bootedAt - now > timeoutNanos ? bootedAt : now + timeoutNanos, request, timeoutMillis);
    }

    /** Repeats the request until it is answered or the clock shows {@code giveUp}; null: no answer. */
    private Frame exchangeUntil(long giveUp, Frame request, int timeoutMillis) throws PortException {
        long repeatNanos = Math.min(timeoutMillis, REPEAT_MILLIS) * NANOS_PER_MILLI;
        Frame answer = null;
        for (long left = giveUp - clock.nanos(); answer == null && left > 0; left = giveUp - clock.nanos()) {
            long sent = ask(request, timeoutMillis);
            answer = inbox.next(sent + Math.min(left, repeatNanos));
            while (answer == null && answerIsComing(sent) && giveUp - clock.nanos() > 0) {
                answer = inbox.next(inbox.lastByteNanos() + QUIET_NANOS); // asking again would drop what has come of it
            }
        }
        return answer == null ? null : completed(answer, timeoutMillis);
    }

    private boolean answerIsComing(long sent) {
        return inbox.lastByteNanos() - sent > 0 && clock.nanos() - inbox.lastByteNanos() < QUIET_NANOS;
    }

    /** Writes a request and waits for its answer; null: none came. */
    private Frame exchange(Frame request, int timeoutMillis) throws PortException {
        Frame answer = inbox.next(ask(request, timeoutMillis) + timeoutMillis * NANOS_PER_MILLI);
        return answer == null ? null : completed(answer, timeoutMillis);
    }

    /** Writes a request, and returns when its last byte leaves. */
    private long ask(Frame request, int timeoutMillis) throws PortException {
        long sent = writer.write(FrameWriter.Kind.REQUEST, request, timeoutMillis, inbox::clear);
        history.asked(sent);
        return sent;
    }

    /** Brings the exchange whose first message has come to its end. */
    private Frame completed(Frame answer, int timeoutMillis) throws PortException {
        ready = true;
        Frame last = answer;
        if (history.mayBeLate()) {
            last = lastBeforeSilence(answer, timeoutMillis * NANOS_PER_MILLI);
        } else {
            history.answered(clock.nanos());
            last = newest(answer); // behind a frame that was cut comes the intact one
        }
        writer.answered(clock.nanos());
        return last;
    }

    /** The newest message that is there already: {@code message}, unless others have come behind it. */
    private Frame newest(Frame message) throws PortException {
        Frame newer = inbox.newest();
        return newer == null ? message : newer;
    }

    private Frame lastBeforeSilence(Frame first, long timeoutNanos) throws PortException {
        long now = clock.nanos();
        long giveUp = now + timeoutNanos;
        long settlingNanos = history.settlingNanos(now, timeoutNanos);
        Frame last = first;
        while (giveUp - clock.nanos() > 0) {
            long left = Math.min(inbox.lastByteNanos() + settlingNanos - clock.nanos(), giveUp - clock.nanos());
            Frame later = inbox.next(clock.nanos() + left);
            if (later != null) {
                last = later;
            } else if (clock.nanos() - inbox.lastByteNanos() >= settlingNanos) {
                history.settled();
                return last;
            }
        }
        return last; // the line does not rest: the next answer may be late too
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
            Thread.currentThread().interrupt();
            throw new PortInterruptedException(port());
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
            return work.run();
        } catch (PortGoneException e) {
            end(e.getMessage());
            throw e;
        }
    }
}
