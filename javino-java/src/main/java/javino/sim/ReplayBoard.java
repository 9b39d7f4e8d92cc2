package javino.sim;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import java.util.function.Consumer;
import javino.Frame;
import javino.FrameDecoder;
import javino.LineClock;
import javino.PerceptsRequest;
import javino.PortException;
import javino.Protocol;
import javino.Transport;

/**
 * A board that says what a board said once: {@code SimulatedBoards.plugIn("robot", ReplayBoard.of(Recording.read(file)))}, or without that the
 * port {@code replay:FILE}.
 *
 * <p>If the recorded board was asked for its percepts, it answers each request with what that board had said by then, counted from the
 * first request, and with the last of it when the recording is over. Else it says everything unasked at its time, counted from the opening
 * of the port, and falls silent. It speaks both versions of the protocol, and takes any command.
 */
public final class ReplayBoard implements SimulatedBoard {
    private static final int BUFFER = 256;
    private static final int READ_MILLIS = 100;
    private static final int WRITE_MILLIS = 10_000;
    private static final long NANOS_PER_MILLI = 1_000_000L;

    private final List<Recording.Entry> said;
    private final boolean asked;
    private final boolean inTurn;
    private final boolean repeated;
    private final Consumer<String> commands;
    private final LineClock clock;

    private ReplayBoard(List<Recording.Entry> said, boolean asked, boolean inTurn, boolean repeated, Consumer<String> commands, LineClock clock) {
        this.said = said;
        this.asked = asked;
        this.inTurn = inTurn;
        this.repeated = repeated;
        this.commands = commands;
        this.clock = clock;
    }

    /** A board that goes by the machine's clock. */
    public static ReplayBoard of(Recording recording) {
        return of(recording, LineClock.system());
    }

    /**
     * @param clock what the recording's times are of
     * @throws IllegalArgumentException if the board says nothing in the recording
     */
    public static ReplayBoard of(Recording recording, LineClock clock) {
        List<Recording.Entry> said = recording.received();
        if (said.isEmpty()) {
            throw new IllegalArgumentException("the recording holds nothing that a board said");
        }
        return new ReplayBoard(said, recording.isOfRequests(), false, false, command -> { }, clock);
    }

    /** This board answering the first request with the first thing that was said, the second with the second, whatever the time. */
    public ReplayBoard inTurn() {
        return new ReplayBoard(said, true, true, repeated, commands, clock);
    }

    /** This board beginning anew when the recording is over. */
    public ReplayBoard repeated() {
        return new ReplayBoard(said, asked, inTurn, true, commands, clock);
    }

    /** This board telling {@code listener} each command that it gets, on its own thread. */
    public ReplayBoard tellingCommandsTo(Consumer<String> listener) {
        return new ReplayBoard(said, asked, inTurn, repeated, listener, clock);
    }

    @Override
    public void run(Transport line) throws PortException, InterruptedException {
        new Run(line).run();
    }

    /** Milliseconds from the recording's first message to the end of its last, if each has as much time as they have on average. */
    private long periodMillis() {
        long span = said.get(said.size() - 1).millis() - said.get(0).millis();
        return Math.max(1, said.size() == 1 ? span : span + span / (said.size() - 1));
    }

    private long offsetMillis(int number) {
        long rounds = number / said.size();
        return rounds * periodMillis() + said.get(number % said.size()).millis() - said.get(0).millis();
    }

    /**
     * What fits into frames of version 1: a message that does not is cut behind percepts, as boards do, and one percept that does not is left
     * out.
     */
    private static List<String> parts(String message) {
        List<String> parts = new ArrayList<>();
        String rest = message;
        while (rest.length() > Frame.MAX_PAYLOAD) {
            int cut = rest.lastIndexOf(';', Frame.MAX_PAYLOAD - 1) + 1;
            if (cut > 0) {
                parts.add(rest.substring(0, cut));
            } else {
                cut = rest.indexOf(';') + 1;
            }
            rest = cut == 0 ? "" : rest.substring(cut);
        }
        if (!rest.isEmpty() || parts.isEmpty()) {
            parts.add(rest);
        }
        return parts;
    }

    /** One use of the port. */
    private final class Run {
        private final Transport line;
        private final FakeBoardVoice voice = new FakeBoardVoice(Protocol.AUTO);
        private final Deque<Frame> queue = new ArrayDeque<>();
        private final FrameDecoder decoder;
        private final byte[] buffer = new byte[BUFFER];
        private final long openedNanos = clock.nanos();
        private Long firstRequestNanos;
        private int version = 1; // of what was heard last
        private int next; // of what was said: the number of the next; of what is said unasked, it goes on counting in further rounds

        Run(Transport line) {
            this.line = line;
            decoder = new FrameDecoder(FrameDecoder.interByteTimeoutNanos(line.line()), voice.reads(), queue::add);
        }

        void run() throws PortException, InterruptedException {
            while (true) {
                receive(millisToWait());
                while (!queue.isEmpty()) {
                    handle(queue.remove());
                }
                if (!asked) {
                    speak();
                }
            }
        }

        private void receive(int timeoutMillis) throws PortException {
            int count = line.read(buffer, 0, buffer.length, timeoutMillis);
            while (count > 0) {
                decoder.acceptUnbroken(buffer, 0, count, clock.nanos());
                count = line.read(buffer, 0, buffer.length, 0);
            }
            decoder.idle(clock.nanos());
        }

        private int millisToWait() {
            if (asked || isOver()) {
                return READ_MILLIS;
            }
            return (int) Math.max(0, Math.min(READ_MILLIS, offsetMillis(next) - millisSince(openedNanos)));
        }

        private boolean isOver() {
            return !repeated && next >= said.size();
        }

        private long millisSince(long nanos) {
            return (clock.nanos() - nanos) / NANOS_PER_MILLI;
        }

        private void speak() throws PortException, InterruptedException {
            while (!isOver() && offsetMillis(next) <= millisSince(openedNanos)) {
                say(said.get(next++ % said.size()).message(), version);
            }
        }

        private void handle(Frame frame) throws PortException, InterruptedException {
            version = frame.version();
            if (!voice.isRepeated(frame)) {
                String message = frame.text();
                if (!PerceptsRequest.isIn(message)) {
                    commands.accept(message);
                } else if (asked) {
                    say(answer(), frame.version());
                }
                voice.handled(frame, false);
            }
            byte[] outcome = voice.outcome(frame);
            if (outcome != null) {
                write(outcome);
            }
        }

        private String answer() {
            if (firstRequestNanos == null) {
                firstRequestNanos = clock.nanos();
            }
            if (!inTurn) {
                long millis = millisSince(firstRequestNanos);
                return said.get(indexAt(repeated ? millis % periodMillis() : millis)).message();
            }
            int number = next;
            next = repeated ? (next + 1) % said.size() : Math.min(next + 1, said.size() - 1);
            return said.get(number).message();
        }

        /** The last of what had been said by then. */
        private int indexAt(long millis) {
            int from = 0;
            int to = said.size();
            while (to - from > 1) {
                int middle = (from + to) / 2;
                if (offsetMillis(middle) <= millis) {
                    from = middle;
                } else {
                    to = middle;
                }
            }
            return from;
        }

        private void say(String message, int version) throws PortException, InterruptedException {
            for (String part : version == 1 ? parts(message) : List.of(message)) {
                write(voice.message(part, version));
            }
        }

        private void pause(long nanos) throws InterruptedException {
            Lock lock = clock.newLock(false);
            Condition never = lock.newCondition();
            lock.lock();
            try {
                clock.await(never, nanos);
            } finally {
                lock.unlock();
            }
        }

        private void write(byte[] bytes) throws PortException, InterruptedException {
            line.write(bytes, 0, bytes.length, WRITE_MILLIS);
            pause(bytes.length * line.line().byteNanos()); // a board does not read while it sends
        }
    }
}
