package javino.sim;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import java.util.function.BooleanSupplier;
import javino.Frame;
import javino.LineClock;
import javino.PortException;
import javino.Protocol;
import javino.Transport;

/** The program that runs on a {@link FakeBoard}: reads a message, does what the script says, and begins again. */
final class FakeBoardSketch implements SimulatedBoard {
    private static final int READ_MILLIS = 100;
    private static final long POLL_NANOS = TimeUnit.MILLISECONDS.toNanos(1);

    private final LineClock clock;
    private final Lock lock;
    private final Condition changed;
    private final FakeBoardScript script;
    private final FakeBoardRecord record;
    private BoardLoop open; // guarded by lock, as is stalled
    private boolean stalled;
    private volatile int queueSize = Integer.MAX_VALUE;
    private volatile int loopMillis;
    private volatile int bootMillis;
    private volatile Protocol protocol = Protocol.V1;

    FakeBoardSketch(FakeBoardScript script, FakeBoardRecord record, LineClock clock) {
        this.clock = clock;
        lock = clock.newLock(false);
        changed = lock.newCondition();
        this.script = script;
        this.record = record;
    }

    void queueSize(int messages) {
        queueSize = messages;
    }

    void loopTakes(int millis) {
        loopMillis = millis;
    }

    void bootTakes(int millis) {
        bootMillis = millis;
    }

    void version2() {
        protocol = Protocol.AUTO;
    }

    void stall(boolean value) {
        change(() -> stalled = value);
    }

    @Override
    public void run(Transport line) throws PortException, InterruptedException {
        BoardLoop loop = new BoardLoop(line, protocol, clock);
        setOpen(loop);
        try {
            boot(loop);
            while (true) {
                awaitRunning();
                loop.receive(READ_MILLIS);
                if (awaitRunning()) {
                    loop.receive(0);
                }
                loseWhatDoesNotFit(loop);
                Frame message = loop.take();
                if (message != null) {
                    handle(message, loop);
                }
                        loop.pause(TimeUnit.MILLISECONDS.toNanos(loopMillis));
            }
        } finally {
            setClosed(loop);
        }
    }

    private void boot(BoardLoop loop) throws PortException, InterruptedException {
        if (bootMillis > 0) {
            loop.pause(TimeUnit.MILLISECONDS.toNanos(bootMillis));
            loop.ignore();
        }
    }

    private void loseWhatDoesNotFit(BoardLoop loop) {
        while (loop.waiting() > queueSize) {
            record.overwritten(loop.overwrite().text());
        }
    }

    private void handle(Frame frame, BoardLoop loop) throws PortException, InterruptedException {
        String message = frame.text();
        FakeBoard.Rule rule = script.ruleFor(message).orElse(null);
        record.received(message, rule != null);
        loop.markHandled(); // what follows does not change what has been received
        if (rule == null) {
            loop.acknowledge(frame);
            return;
        }
        loop.pause(TimeUnit.MILLISECONDS.toNanos(rule.delayMillis()));
        byte[] answer = rule.reply(message, loop::bytesOf);
        if (answer != null) {
            loop.send(answer);
        }
        if (rule.isRefused()) {
            loop.refuse(frame);
        } else {
            loop.acknowledge(frame);
        }
    }

    /** Sends a message to the port that is open. */
    void send(String message) throws PortException {
        BoardLoop loop = requireOpen();
        loop.write(loop.bytesOf(message));
    }

    /** Writes bytes to the port that is open. */
    void write(byte[] bytes) throws PortException {
        requireOpen().write(bytes);
    }

    private BoardLoop requireOpen() {
        lock.lock();
        try {
            if (open == null) {
                throw new IllegalStateException("the board has nobody to send to: its port is not open");
            }
            return open;
        } finally {
            lock.unlock();
        }
    }

    void awaitOpen(String port, int timeoutMillis) {
        if (!await(() -> open != null, timeoutMillis)) {
            throw new AssertionError("nobody opened " + port + " within " + timeoutMillis + " ms");
        }
    }

    /**
     * Waits until all that was sent to the board has been received, but not for a board that is stalled, or that does not run.
     *
     * @param starting whether the board's thread lives, so that this program runs or is about to
     */
    void awaitDrained(BooleanSupplier starting, int timeoutMillis) {
        lock.lock();
        try {
            BoardLoop first = open;
            int silences = first == null ? 0 : first.silences();
            await(() -> stalled || (open == null ? !starting.getAsBoolean() : open.isDrained(open == first ? silences : 0)), timeoutMillis);
        } finally {
            lock.unlock();
        }
    }

    /** Waits until {@code reached}, which is asked under the lock; false if it is not within {@code timeoutMillis}. */
    private boolean await(BooleanSupplier reached, int timeoutMillis) {
        lock.lock();
        try {
            long end = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
            while (!reached.getAsBoolean()) {
                long left = end - clock.nanos();
                if (left <= 0) {
                    return false;
                }
                clock.await(changed, Math.min(left, POLL_NANOS));
            }
            return true;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError("interrupted while waiting for a fake board", e);
        } finally {
            lock.unlock();
        }
    }

    private void setOpen(BoardLoop loop) {
        change(() -> open = loop);
    }

    private void setClosed(BoardLoop loop) {
        change(() -> open = open == loop ? null : open); // a board that was plugged in again may be open anew by now
    }

    private void change(Runnable change) {
        lock.lock();
        try {
            change.run();
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /** Waits while the board is stalled; returns whether it was. */
    private boolean awaitRunning() throws InterruptedException {
        lock.lockInterruptibly();
        try {
            boolean waited = stalled;
            while (stalled) {
                changed.await();
            }
            return waited;
        } finally {
            lock.unlock();
        }
    }
}
