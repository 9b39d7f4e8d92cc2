package javino;

import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;

/**
 * The one queue of a line: gives commands and requests their turns, each when the {@link Pacer} lets it, and writes their frames. One command
 * at a time is under way, from its turn until its outcome; requests go out meanwhile, and before the commands that wait.
 *
 * <p>Safe on any thread; no lock is held while bytes are written.
 */
final class FrameWriter {
    /** What a frame is for: the pacer treats the two differently. */
    enum Kind { ACTION, REQUEST }

    /** What is done after a frame's turn has come and right before it is written. */
    interface BeforeWrite {
        void run() throws PortException;
    }

    /** Longer than anything is waited for. */
    static final long FOREVER = Long.MAX_VALUE / 4;

    private final Lock lock;
    private final Condition changed;
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
        lock = clock.newLock(false);
        changed = lock.newCondition();
    }

    /** Queues a command. */
    void submit(Command command) throws PortGoneException {
        locked(() -> {
            requireLine();
            commands.add(command);
        });
    }

    /** Takes a command that has not begun to go out from the queue, for good; false if it has. */
    boolean withdraw(Command command) {
        lock.lock();
        try {
            changed.signalAll();
            return command.withdraw();
        } finally {
            lock.unlock();
        }
    }

    /**
     * Waits until a command may be written next: until one waits and none is under way.
     *
     * @param own the wait ends when this command is over; null: it has no such end
     * @param deadline until when {@code own} may wait for its turn
     * @return whether there is one
     */
    boolean awaitWork(Command own, long deadline) throws PortException {
        lock();
        try {
            while (own == null || !own.isOver()) {
                requireLine();
                if (underWay == null && commands.head() != null) {
                    return true;
                }
                long left = own == null || !own.isWaiting() ? FOREVER : deadline - clock.nanos();
                if (left <= 0) {
                    return false;
                }
                await(left);
            }
            return false;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Waits for the turn of the next command, which is under way from then on until {@link #finish}, and must be written with {@link #writeNow}.
     *
     * @return null if its turn has not come by {@code deadline}, or there is none, or another thread has it
     */
    Command awaitCommand(long deadline) throws PortException {
        lock();
        try {
            while (true) {
                requireLine();
                Command head = underWay == null ? commands.head() : null;
                long now = clock.nanos();
                if (head == null || deadline - now < 0) {
                    return null;
                }
                long wait = writing || turnsAwaited > 0 ? FOREVER : pacer.nanosUntilAction(pacer.lengthOf(head.frame()), now);
                if (wait == 0) {
                    head.begin();
                    underWay = head;
                    writing = true;
                    return head;
                }
                await(Math.min(wait, deadline - now + 1));
            }
        } finally {
            lock.unlock();
        }
    }

    /** Withdraws the command whose turn is next; null if there is none. */
    Command withdrawNext() {
        lock.lock();
        try {
            Command head = underWay == null ? commands.head() : null;
            if (head != null) {
                head.withdraw();
            }
            return head;
        } finally {
            lock.unlock();
        }
    }

    /** Withdraws all commands that wait. */
    List<Command> withdrawAll() {
        lock.lock();
        try {
            return commands.removeAll();
        } finally {
            lock.unlock();
        }
    }

    /** Records that the command under way has arrived, or failed: the next one may go. */
    void finish(Command command) {
        locked(() -> underWay = underWay == command ? null : underWay);
    }

    /** Records that the outcome of a command has been reported. */
    void reported() {
        locked(commands::finished);
    }

    /** Waits, at most {@code nanos}, until the commands that have been submitted so far are over. */
    void awaitCommandsSoFar(long nanos) throws PortException {
        lock();
        try {
            long submitted = commands.submitted();
            long deadline = clock.nanos() + nanos;
            for (long left = nanos; left > 0 && !commands.areOver(submitted); left = deadline - clock.nanos()) {
                requireLine();
                await(left);
            }
        } finally {
            lock.unlock();
        }
    }

    /**
     * Waits for a turn of its own, before the commands that wait, and writes a frame.
     *
     * @param timeoutMillis milliseconds to wait at most for the turn, and again for the driver
     * @return when its last byte leaves the line, by the clock
     * @throws PortTimeoutException if its turn did not come in time, and then nothing was written; or if the driver did not take it
     */
    long write(Kind kind, Frame frame, int timeoutMillis, BeforeWrite beforeWrite) throws PortException {
        awaitTurn(kind, frame, timeoutMillis);
        return writeNow(kind, frame, timeoutMillis, beforeWrite);
    }

    private void awaitTurn(Kind kind, Frame frame, int timeoutMillis) throws PortException {
        lock();
        turnsAwaited++;
        try {
            long due = clock.nanos();
            long deadline = due + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
            while (true) {
                requireLine();
                long now = clock.nanos();
                long wait = writing ? FOREVER
                        : kind == Kind.ACTION ? pacer.nanosUntilAction(frame.length(), now) : pacer.nanosUntilRequest(due, now);
                if (wait == 0) {
                    writing = true;
                    return;
                }
                if (deadline - now <= 0) {
                    throw noTime(frame, timeoutMillis);
                }
                await(Math.min(wait, deadline - now));
            }
        } finally {
            turnsAwaited--;
            changed.signalAll();
            lock.unlock();
        }
    }

    /** Why a frame was not written whose turn did not come. */
    PortTimeoutException noTime(Frame frame, int timeoutMillis) {
        return new PortTimeoutException(transport.name(), "port " + transport.name() + " had no time for a message of " + frame.length()
                + " bytes within " + timeoutMillis + " ms; the line is busy with those before it");
    }

    /** Writes a frame whose turn has come; as {@link #write}. */
    long writeNow(Kind kind, Frame frame, int timeoutMillis, BeforeWrite beforeWrite) throws PortException {
        byte[] bytes = frame.toBytes();
        long end = 0;
        try {
            beforeWrite.run();
            long start = clock.nanos();
            try {
                transport.write(bytes, 0, bytes.length, timeoutMillis);
            } finally {
                end = wrote(kind, bytes.length, start); // also of a write that failed some bytes may have left
            }
        } finally {
            locked(() -> writing = false);
        }
        return end;
    }

    private long wrote(Kind kind, int bytes, long start) {
        lock.lock();
        try {
            long now = clock.nanos();
            return kind == Kind.ACTION ? pacer.wroteAction(bytes, start, now) : pacer.wroteRequest(bytes, start, now);
        } finally {
            lock.unlock();
        }
    }

    /** Waits until the clock shows {@code nanos}. */
    void awaitTime(long nanos) throws PortException {
        lock();
        try {
            for (long left = nanos - clock.nanos(); left > 0; left = nanos - clock.nanos()) {
                requireLine();
                await(left);
            }
        } finally {
            lock.unlock();
        }
    }

    /** Records that {@code bytes} have been read at {@code now}. */
    void received(int bytes, long now) {
        lock.lock();
        try {
            pacer.received(bytes, now);
        } finally {
            lock.unlock();
        }
    }

    /** Records that a message is complete, the answer to the last request if one is awaited: actions go out that waited for it. */
    void answered(long now) {
        locked(() -> pacer.answered(now));
    }

    /** Keeps the manners of version 2 from now on. */
    void speakVersion2() {
        locked(pacer::speakVersion2);
    }

    /** Ends the line: who waits here, or comes later, gets a {@link PortGoneException} with {@code reason}. */
    void end(String reason) {
        locked(() -> endReason = endReason == null ? reason : endReason);
    }

    /** Whether the line is still there, as far as it is known. */
    boolean hasLine() {
        lock.lock();
        try {
            return endReason == null;
        } finally {
            lock.unlock();
        }
    }

    /** Does nothing on a line that is there; else throws with the first reason that {@link #end} was given. */
    void requireLine() throws PortGoneException {
        lock.lock();
        try {
            if (endReason != null) {
                throw new PortGoneException(transport.name(), endReason);
            }
        } finally {
            lock.unlock();
        }
    }

    private interface Change<E extends Exception> {
        void run() throws E;
    }

    private <E extends Exception> void locked(Change<E> change) throws E {
        lock.lock();
        try {
            change.run();
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    private void lock() throws PortInterruptedException {
        try {
            lock.lockInterruptibly();
        } catch (InterruptedException e) {
            throw interrupted();
        }
    }

    private void await(long nanos) throws PortInterruptedException {
        try {
            if (nanos >= FOREVER) {
                changed.await();
            } else {
                clock.await(changed, nanos);
            }
        } catch (InterruptedException e) {
            throw interrupted();
        }
    }

    private PortInterruptedException interrupted() {
        return PortInterruptedException.remarking(transport.name());
    }
}
