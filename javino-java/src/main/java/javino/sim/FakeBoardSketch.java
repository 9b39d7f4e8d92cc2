package javino.sim;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import javino.Frame;
import javino.FrameDecoder;
import javino.LineClock;
import javino.PortException;
import javino.Protocol;
import javino.Transport;

/** The program that runs on a {@link FakeBoard}: reads a message, does what the script says, and begins again. */
final class FakeBoardSketch implements SimulatedBoard {
    private static final int READ_MILLIS = 100;
    private static final int WRITE_MILLIS = 10_000;
    private static final int BUFFER = 256;

    private final LineClock clock;
    private final Lock lock;
    private final Condition changed;
    private final Lock writing; // the script answers on the board's thread, tests send on theirs
    private final FakeBoardScript script;
    private final FakeBoardRecord record;
    private Transport open; // guarded by lock, as is stalled
    private boolean stalled;
    private volatile int queueSize = Integer.MAX_VALUE;
    private volatile int loopMillis;
    private volatile int bootMillis;
    private volatile FakeBoardVoice voice = new FakeBoardVoice(Protocol.V1);

    FakeBoardSketch(FakeBoardScript script, FakeBoardRecord record, LineClock clock) {
        this.clock = clock;
        lock = clock.newLock(false);
        changed = lock.newCondition();
        writing = clock.newLock(false);
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
        voice = new FakeBoardVoice(Protocol.AUTO);
    }

    void stall(boolean value) {
        lock.lock();
        try {
            stalled = value;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    @Override
    public void run(Transport line) throws PortException, InterruptedException {
        setOpen(line);
        try {
            boot(line);
            voice.reset();
            Deque<Frame> queue = new ArrayDeque<>();
            long timeout = FrameDecoder.interByteTimeoutNanos(line.line());
            FrameDecoder decoder = new FrameDecoder(timeout, voice.reads(), frame -> enqueue(queue, frame));
            while (true) {
                awaitRunning();
                receive(line, decoder, queue.isEmpty() ? READ_MILLIS : 0);
                awaitRunning();
                if (!queue.isEmpty()) {
                    handle(queue.remove(), line);
                }
                pause(TimeUnit.MILLISECONDS.toNanos(loopMillis));
            }
        } finally {
            setClosed(line);
        }
    }

    private void boot(Transport line) throws PortException, InterruptedException {
        if (bootMillis > 0) {
            pause(TimeUnit.MILLISECONDS.toNanos(bootMillis));
            byte[] lost = new byte[MemoryLine.CAPACITY];
            line.read(lost, 0, lost.length, 0);
        }
    }

    /** Does nothing for so long. */
    private void pause(long nanos) throws InterruptedException {
        lock.lockInterruptibly();
        try {
            long end = clock.nanos() + nanos;
            for (long left = nanos; left > 0; left = end - clock.nanos()) {
                clock.await(changed, left);
            }
        } finally {
            lock.unlock();
        }
    }

    /** Waits for bytes, and takes all that came by then. */
    private void receive(Transport line, FrameDecoder decoder, int timeoutMillis) throws PortException {
        byte[] buffer = new byte[BUFFER];
        int count = line.read(buffer, 0, buffer.length, timeoutMillis);
        while (count > 0) {
            decoder.acceptUnbroken(buffer, 0, count, clock.nanos());
            count = line.read(buffer, 0, buffer.length, 0);
        }
        decoder.idle(clock.nanos());
    }

    private void enqueue(Deque<Frame> queue, Frame message) {
        if (queue.size() == queueSize) {
            record.overwritten(queue.remove().text());
        }
        queue.add(message);
    }

    private void handle(Frame frame, Transport line) throws PortException, InterruptedException {
        if (voice.isRepeated(frame)) {
            answer(voice.outcome(frame), line);
            return;
        }
        String message = frame.text();
        FakeBoard.Rule rule = script.ruleFor(message).orElse(null);
        record.received(message, rule != null);
        if (rule != null) {
            pause(TimeUnit.MILLISECONDS.toNanos(rule.delayMillis()));
            answer(rule.reply(message, text -> voice.message(text, frame.version())), line);
        }
        voice.handled(frame, rule != null && rule.isRefused());
        answer(voice.outcome(frame), line);
    }

    private void answer(byte[] answer, Transport line) throws PortException, InterruptedException {
        if (answer != null) {
            write(line, answer);
            pause(answer.length * line.line().byteNanos()); // a board does not read while it sends
        }
    }

    /** Writes a message to the port that is open. */
    void send(String message) throws PortException {
        write(voice.message(message));
    }

    /** Writes bytes to the port that is open. */
    void write(byte[] bytes) throws PortException {
        Transport line;
        lock.lock();
        try {
            line = open;
        } finally {
            lock.unlock();
        }
        if (line == null) {
            throw new IllegalStateException("the board has nobody to send to: its port is not open");
        }
        write(line, bytes);
    }

    private void write(Transport line, byte[] bytes) throws PortException {
        writing.lock();
        try {
            line.write(bytes, 0, bytes.length, WRITE_MILLIS);
        } finally {
            writing.unlock();
        }
    }

    void awaitOpen(String port, int timeoutMillis) {
        long left = TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        lock.lock();
        try {
            while (open == null) {
                if (left <= 0) {
                    throw new AssertionError("nobody opened " + port + " within " + timeoutMillis + " ms");
                }
                left = changed.awaitNanos(left);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError("interrupted while waiting for somebody to open " + port, e);
        } finally {
            lock.unlock();
        }
    }

    private void setOpen(Transport line) {
        lock.lock();
        try {
            open = line;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    private void setClosed(Transport line) {
        lock.lock();
        try {
            if (open == line) { // a board that was plugged in again may be open anew by now
                open = null;
            }
        } finally {
            lock.unlock();
        }
    }

    private void awaitRunning() throws InterruptedException {
        lock.lockInterruptibly();
        try {
            while (stalled) {
                changed.await();
            }
        } finally {
            lock.unlock();
        }
    }
}
