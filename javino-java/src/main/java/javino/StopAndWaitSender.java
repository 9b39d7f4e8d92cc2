package javino;

import java.util.concurrent.TimeUnit;

/**
 * Sends commands to a version 2 board, one at a time: each is retransmitted until the board has acknowledged or refused it.
 *
 * <p>A board knows a retransmission by its sequence number, and does not act again; it remembers that for some seconds. So a command is
 * not sent again later than {@value #LAST_REPEAT_MILLIS} ms after the first time. Commands have a count of their own, since a request in
 * between does not make a board forget the last one. One thread at a time.
 */
final class StopAndWaitSender implements CommandSender {
    private static final int REPEATS = 3;
    private static final int LAST_REPEAT_MILLIS = 2500;
    private static final long QUIET_NANOS = TimeUnit.MILLISECONDS.toNanos(Pacer.QUIET_MILLIS);
    private static final int FIRST_TIMEOUT_MILLIS = 150;
    /** With it the last repetition is on time, and an action that takes five seconds is still waited for. */
    private static final long MAX_TIMEOUT_NANOS = TimeUnit.MILLISECONDS.toNanos(350);

    private static final int ACKNOWLEDGEMENT_LENGTH = 12;

    private final Inbox inbox;
    private final FrameWriter writer;
    private final LineClock clock;
    private final String port;
    private final String board;
    private final long acknowledgementNanos; // on the line
    private int sequence;
    private final RoundTripTimes times = new RoundTripTimes(FIRST_TIMEOUT_MILLIS);

    /** @param board a name that the board has whatever its port is called */
    StopAndWaitSender(String port, String board, Inbox inbox, FrameWriter writer, LineClock clock, LineSettings line) {
        this.port = port;
        this.board = board;
        this.inbox = inbox;
        this.writer = writer;
        this.clock = clock;
        acknowledgementNanos = ACKNOWLEDGEMENT_LENGTH * line.byteNanos();
        // another program that had the port a moment ago is unlikely to have stopped at the same number
        sequence = LastSequences.of(
                board, (int) Math.floorMod(TimeUnit.NANOSECONDS.toMillis(clock.nanos()), (long) Frame.SEQUENCES));
    }

    @Override
    public void send(Command command) throws PortException {
        sequence = (sequence + 1) % Frame.SEQUENCES;
        LastSequences.used(board, sequence);
        inbox.expectOutcome(sequence);
        Inbox.Outcome outcome = repeat(command, command.frame().toVersion2(Frame.ACK_WANTED, sequence));
        String text = command.frame().text();
        if (outcome == null) {
            throw new ActionUnconfirmedException(
                    port,
                    "port " + port + " did not say that it acted on \"" + text
                            + "\"; it may have, or the board does not run any more");
        }
        if (outcome == Inbox.Outcome.REFUSED) {
            throw new ActionRefusedException(
                    port,
                    "the board at port " + port + " refuses \"" + text
                            + "\": it does not know the action, or not with these arguments");
        }
    }

    private Inbox.Outcome repeat(Command command, Frame frame) throws PortException {
        long timeout = timeoutNanos();
        long first = writer.writeNow(FrameWriter.Kind.ACTION, frame, MAX_WRITE_MILLIS, () -> inbox.sends(frame));
        Inbox.Outcome outcome = await(command, first, timeout);
        if (outcome != null) {
            times.answeredAfter(clock.nanos() - first);
        }
        for (int repeats = 0; outcome == null && !isOver(command) && repeats < REPEATS; repeats++) {
            timeout *= 2;
            boolean remembered = clock.nanos() - first < TimeUnit.MILLISECONDS.toNanos(LAST_REPEAT_MILLIS);
            outcome = await(command, remembered ? sendAgain(frame) : clock.nanos(), timeout);
        }
        return outcome;
    }

    private boolean isOver(Command command) {
        return command.isOver() || command.nanosLeft(clock.nanos(), 1) <= 0;
    }

    private long sendAgain(Frame frame) throws PortException {
        return writer.write(FrameWriter.Kind.ACTION, frame, MAX_WRITE_MILLIS, () -> inbox.sends(frame));
    }

    private long timeoutNanos() {
        return Math.min(times.timeoutNanos(), MAX_TIMEOUT_NANOS) + 2 * acknowledgementNanos;
    }

    /** Waits for the outcome, and up to twice as long while the board is sending something else. */
    private Inbox.Outcome await(Command command, long sent, long timeout) throws PortException {
        Inbox.Outcome outcome = outcome(command, sent + timeout);
        long giveUp = sent + 2 * timeout;
        while (outcome == null
                && !isOver(command)
                && giveUp - clock.nanos() > 0
                && clock.nanos() - inbox.lastByteNanos() < QUIET_NANOS) {
            outcome = outcome(command, Math.min(giveUp, inbox.lastByteNanos() + QUIET_NANOS));
        }
        return outcome;
    }

    private Inbox.Outcome outcome(Command command, long deadline) throws PortException {
        long now = clock.nanos();
        return inbox.outcome(now + command.nanosLeft(now, deadline - now));
    }
}
