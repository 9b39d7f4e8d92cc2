package javino.sim;

import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javino.Frame;
import javino.LineClock;
import javino.PortException;
import javino.Protocol;
import javino.Transport;

/** The program that runs on a {@link FakeBoard}: reads a message, does what the script says, and begins again. */
final class FakeBoardSketch implements SimulatedBoard {
    private static final int READ_MILLIS = 100;

    // as the methods of FakeBoard that set them say
    volatile int queueSize = Integer.MAX_VALUE;
    volatile int loopMillis;
    volatile int bootMillis;
    volatile Protocol protocol = Protocol.V1;

    private final FakeBoardScript script;
    private final FakeBoardRecord record;
    private final FakeBoardMonitor monitor;
    private final LineClock clock;
    private BoardLoop open; // guarded by the monitor, as is stalled
    private boolean stalled;

    FakeBoardSketch(FakeBoardScript script, FakeBoardRecord record, FakeBoardMonitor monitor, LineClock clock) {
        this.script = script;
        this.record = record;
        this.monitor = monitor;
        this.clock = clock;
    }

    void stall(boolean value) {
        monitor.locked(() -> stalled = value);
    }

    @Override
    public void run(Transport line) throws PortException, InterruptedException {
        BoardLoop loop = new BoardLoop(line, protocol, clock);
        monitor.locked(() -> open = loop);
        try {
            boot(loop);
            while (true) {
                monitor.awaitWhile(() -> stalled);
                loop.receive(READ_MILLIS);
                if (monitor.awaitWhile(() -> stalled)) {
                    loop.receive(0);
                }
                while (loop.waiting() > queueSize) {
                    record.overwritten(loop.overwrite().text());
                }
                Frame message = loop.take();
                if (message != null) {
                    handle(message, loop);
                }
                loop.pause(TimeUnit.MILLISECONDS.toNanos(loopMillis));
            }
        } finally {
            // a board that was plugged in again may be open anew by now
            monitor.locked(() -> open = open == loop ? null : open);
        }
    }

    private void boot(BoardLoop loop) throws PortException, InterruptedException {
        if (bootMillis > 0) {
            loop.pause(TimeUnit.MILLISECONDS.toNanos(bootMillis));
            loop.ignore();
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
        loop.pause(TimeUnit.MILLISECONDS.toNanos(rule.delayMillis));
        byte[] answer = rule.reply.apply(message, loop);
        if (answer != null) {
            loop.send(answer);
        }
        if (rule.refused) {
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
        BoardLoop loop = monitor.locked(() -> open);
        if (loop == null) {
            throw new IllegalStateException("the board has nobody to send to: its port is not open");
        }
        return loop;
    }

    void awaitOpen(String port, int timeoutMillis) {
        if (!monitor.await(() -> open != null, timeoutMillis, "waiting for somebody to open " + port)) {
            throw new AssertionError("nobody opened " + port + " within " + timeoutMillis + " ms");
        }
    }

    /**
     * Waits until all that was sent to the board has been received, but not for a board that is stalled, or that does not run.
     *
     * @param starting whether the board's thread lives, so that this program runs or is about to
     */
    void awaitDrained(BooleanSupplier starting, int timeoutMillis) {
        BoardLoop first = monitor.locked(() -> open);
        int silences = first == null ? 0 : first.silences();
        monitor.await(
                () -> stalled
                        || (open == null ? !starting.getAsBoolean() : open.isDrained(open == first ? silences : 0)),
                timeoutMillis,
                "waiting for a fake board");
    }
}
