package javino.sim;

import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javino.LineClock;
import javino.PerceptKind;
import javino.PerceptsRequest;
import javino.PortException;
import javino.PortInterruptedException;
import javino.Protocol;
import javino.Transport;
import javino.wire.BoardAction;
import javino.wire.WireFrame;

/** The program that a {@link FakeBoard} runs. */
final class FakeBoardSketch implements SimulatedBoard {
    private static final int READ_MILLIS = 100;

    // set by methods of FakeBoard
    volatile int queueSize = Integer.MAX_VALUE;
    volatile int loopMillis;
    volatile int bootMillis;
    volatile Protocol protocol = Protocol.V1;
    volatile List<BoardAction> vocabulary = List.of();
    volatile List<PerceptKind> kinds = List.of();
    volatile int rules;

    private final FakeBoardScript script;
    private final FakeBoardRecord record;
    private final FakeBoardMonitor monitor;
    private final LineClock clock;
    private final String port;
    private BoardLoop open; // guarded by the monitor, like stalled
    private boolean stalled;

    FakeBoardSketch(
            String port, FakeBoardScript script, FakeBoardRecord record, FakeBoardMonitor monitor, LineClock clock) {
        this.port = port;
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
        Run run = new Run(line);
        BoardLoop loop = run.loop;
        monitor.locked(() -> open = loop);
        try {
            boot(loop);
            while (true) {
                monitor.awaitWhile(() -> stalled);
                loop.receive(run.millisToRead());
                if (monitor.awaitWhile(() -> stalled)) {
                    loop.receive(0);
                }
                while (loop.waiting() > queueSize) {
                    loop.overwrite().ifPresent(lost -> record.overwritten(lost.text()));
                }
                loop.handleNext();
                run.report();
                loop.pause(TimeUnit.MILLISECONDS.toNanos(loopMillis));
            }
        } finally {
            // another run may have set open by now
            monitor.locked(() -> open = open == loop ? null : open);
        }
    }

    private void boot(BoardLoop loop) throws PortException, InterruptedException {
        if (bootMillis > 0) {
            loop.pause(TimeUnit.MILLISECONDS.toNanos(bootMillis));
            loop.ignore();
        }
    }

    private final class Run implements BoardProgram {
        private final BoardLoop loop;
        private FakeBoard.Rule begun; // rule of the action whose outcome is not reported yet, or null
        private long action; // number of the begun action, or 0 if the session has not numbered it yet
        private long dueNanos;

        Run(Transport line) {
            loop = new BoardLoop(line, this, protocol, BoardSession.Capacity.FULL.withRules(rules), clock);
        }

        @Override
        public List<BoardAction> vocabulary() {
            return vocabulary;
        }

        @Override
        public List<PerceptKind> perceptKinds() {
            return kinds;
        }

        @Override
        public Outcome carryOut(String command) throws PortException, InterruptedException {
            FakeBoard.Rule rule = begin(command);
            String answer = rule == null ? null : answer(rule, command);
            if (answer != null) {
                loop.say(answer);
            }
            if (rule != null
                    && rule.outcomeMillis > 0
                    && begun == null) { // a reflex can run while another action is open
                begun = rule;
                action = 0;
                dueNanos = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(rule.outcomeMillis);
                return Outcome.LATER;
            }
            return rule != null && rule.refused ? Outcome.REFUSED : Outcome.DONE;
        }

        /** Reports the outcome of the begun action, if the outcome is due. */
        void report() throws PortException, InterruptedException {
            if (begun == null) {
                return;
            }
            action = action == 0 ? loop.session().openAction() : action;
            if (clock.nanos() - dueNanos >= 0) {
                FakeBoard.Rule rule = begun;
                begun = null;
                loop.session().report(action, !rule.refused);
            }
        }

        int millisToRead() {
            if (begun == null) {
                return READ_MILLIS;
            }
            long nanos = Math.max(0, dueNanos - clock.nanos());
            return (int) Math.min(READ_MILLIS, TimeUnit.NANOSECONDS.toMillis(nanos) + 1);
        }

        @Override
        public String percepts(String request) throws PortException, InterruptedException {
            FakeBoard.Rule rule = begin(request);
            return rule == null ? null : answer(rule, request);
        }

        @Override
        public String sensors() {
            return script.ruleFor(PerceptsRequest.ALL)
                    .map(rule -> rule.sensors.get())
                    .orElse("");
        }

        /** Records a message. Returns the message's rule, or null if no rule covers it. */
        private FakeBoard.Rule begin(String message) {
            FakeBoard.Rule rule = script.ruleFor(message).orElse(null);
            record.received(message, rule != null);
            loop.markHandled(); // last: from here on a test may read the received messages
            return rule;
        }

        private String answer(FakeBoard.Rule rule, String message) throws PortException, InterruptedException {
            loop.pause(TimeUnit.MILLISECONDS.toNanos(rule.delayMillis));
            byte[] raw = rule.raw;
            if (raw != null) {
                loop.send(raw);
                return null;
            }
            return rule.answer.apply(message);
        }
    }

    void send(String message) throws PortException {
        BoardLoop loop = requireOpen();
        try {
            loop.say(message);
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(port);
        }
    }

    void write(byte[] bytes) throws PortException {
        requireOpen().write(bytes);
    }

    void write(WireFrame frame) throws PortException {
        BoardLoop loop = requireOpen();
        loop.write(frame.toBytes(loop.session().nonce()));
    }

    private BoardLoop requireOpen() {
        BoardLoop loop = monitor.locked(() -> open);
        if (loop == null) {
            throw new IllegalStateException("the board has nobody to send to: its port is not open");
        }
        return loop;
    }

    void awaitOpen(int timeoutMillis) {
        if (!monitor.await(() -> open != null, timeoutMillis, "waiting for somebody to open " + port)) {
            throw new AssertionError("nobody opened " + port + " within " + timeoutMillis + " ms");
        }
    }

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
