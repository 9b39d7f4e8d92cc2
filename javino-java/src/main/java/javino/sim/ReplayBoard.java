package javino.sim;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javino.LineClock;
import javino.PortException;
import javino.Transport;

/**
 * A board that replays the messages of a recorded board: the port {@code replay:FILE}, or
 * {@code SimulatedBoards.plugIn("robot", ReplayBoard.of(LineRecording.read(file)))}.
 *
 * <p>If the recorded board answered requests, this board answers requests too. The recording then runs from the first request on. Each
 * request gets the newest message up to the present moment of the recording. After the end of the recording, each request gets the last
 * message. If the recorded board spoke unasked, this board sends each message at its recorded time, counted from the opening of the port.
 * After the last message, this board falls silent. The board speaks both versions of the protocol, and accepts any command.
 */
public final class ReplayBoard implements SimulatedBoard {
    private static final int READ_MILLIS = 100;

    private final List<LineRecording.Entry> said;
    private final boolean asked;
    private final boolean inTurn;
    private final boolean repeated;
    private final Consumer<String> commands;
    private final LineClock clock;

    private ReplayBoard(
            List<LineRecording.Entry> said,
            boolean asked,
            boolean inTurn,
            boolean repeated,
            Consumer<String> commands,
            LineClock clock) {
        this.said = said;
        this.asked = asked;
        this.inTurn = inTurn;
        this.repeated = repeated;
        this.commands = commands;
        this.clock = clock;
    }

    /** Returns a board that uses the machine's clock. */
    public static ReplayBoard of(LineRecording recording) {
        return of(recording, LineClock.system());
    }

    /**
     * @param clock the clock of the replay
     * @throws IllegalArgumentException if the recording has no message from the board
     */
    public static ReplayBoard of(LineRecording recording, LineClock clock) {
        List<LineRecording.Entry> said = recording.received();
        if (said.isEmpty()) {
            throw new IllegalArgumentException("the recording holds nothing that a board said");
        }
        return new ReplayBoard(said, recording.isOfRequests(), false, false, command -> {}, clock);
    }

    /**
     * Returns a copy of this board that answers request number n with message number n, at any time. A repeated request counts as another
     * request. Version 2 repeats a request if its answer is late.
     */
    public ReplayBoard inTurn() {
        return new ReplayBoard(said, true, true, repeated, commands, clock);
    }

    /** Returns a copy of this board that restarts the recording at its end. */
    public ReplayBoard repeated() {
        return new ReplayBoard(said, asked, inTurn, true, commands, clock);
    }

    /** Returns a copy of this board that passes each command to {@code listener}, on the board's thread. */
    public ReplayBoard tellingCommandsTo(Consumer<String> listener) {
        return new ReplayBoard(said, asked, inTurn, repeated, listener, clock);
    }

    @Override
    public Optional<String> doubt() {
        return asked
                ? Optional.empty()
                : Optional.of(
                        "the recorded board sent its percepts unasked and answers no requests: listen to it, an agent "
                                + "with mode(listen), monitor with --mode listen, describe with --listen");
    }

    @Override
    public void run(Transport line) throws PortException, InterruptedException {
        new Run(line).run();
    }

    /** Returns the length of one pass through the recording, in ms. The last message lasts as long as the others on average. */
    private long periodMillis() {
        long span = said.get(said.size() - 1).millis() - said.get(0).millis();
        return Math.max(1, said.size() == 1 ? span : span + span / (said.size() - 1));
    }

    /**
     * Returns the time at which message {@code number} is due, counted from the first message. Numbers continue when the recording
     * restarts.
     */
    private long offsetMillis(int number) {
        long rounds = number / said.size();
        return rounds * periodMillis()
                + said.get(number % said.size()).millis()
                - said.get(0).millis();
    }

    private final class Run implements BoardProgram {
        private final BoardLoop loop;
        private final long openedNanos = clock.nanos();
        private Long firstRequestNanos;
        private int next; // number of the next message

        Run(Transport line) {
            loop = new BoardLoop(line, this, clock);
        }

        void run() throws PortException, InterruptedException {
            while (true) {
                loop.step(millisToWait());
                if (!asked) {
                    speak();
                }
            }
        }

        private int millisToWait() {
            if (asked || isOver(next)) {
                return READ_MILLIS;
            }
            return (int) Math.max(0, Math.min(READ_MILLIS, offsetMillis(next) - millisSince(openedNanos)));
        }

        private boolean isOver(int number) {
            return !repeated && number >= said.size();
        }

        private long millisSince(long nanos) {
            return TimeUnit.NANOSECONDS.toMillis(clock.nanos() - nanos);
        }

        private void speak() throws PortException, InterruptedException {
            while (!isOver(next) && offsetMillis(next) <= millisSince(openedNanos)) {
                loop.say(loop.sayBeginning(message(next++)));
            }
        }

        private String message(int number) {
            return said.get(number % said.size()).message();
        }

        @Override
        public Outcome carryOut(String command) {
            commands.accept(command);
            return Outcome.DONE;
        }

        @Override
        public String percepts(String request) throws PortException, InterruptedException {
            if (!asked) {
                return null;
            }
            return loop.sayBeginning(answer());
        }

        private String answer() {
            if (firstRequestNanos == null) {
                firstRequestNanos = clock.nanos();
            }
            if (inTurn) {
                return message(isOver(next) ? said.size() - 1 : next++);
            }
            while (!isOver(next + 1) && offsetMillis(next + 1) <= millisSince(firstRequestNanos)) {
                next++;
            }
            return message(next);
        }
    }
}
