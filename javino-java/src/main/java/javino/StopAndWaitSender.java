package javino;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Lock;

/**
 * Takes actions to a version 2 board, one at a time: each is sent until the board has said that it acted, or that it refuses.
 *
 * <p>A board knows by the sequence number, which is repeated, that it has acted already; it remembers that for some seconds. So an action is
 * not sent again later than {@value #LAST_REPEAT_MILLIS} ms after the first time. Actions have a count of their own, since a request in
 * between does not make a board forget the last action. Safe on any thread.
 */
final class StopAndWaitSender {
    private static final long NANOS_PER_MILLI = 1_000_000L;
    private static final int REPEATS = 3;
    private static final int LAST_REPEAT_MILLIS = 2500;
    private static final long QUIET_NANOS = Pacer.QUIET_MILLIS * NANOS_PER_MILLI;
    private static final long FIRST_TIMEOUT_NANOS = 150 * NANOS_PER_MILLI;
    private static final long MIN_TIMEOUT_NANOS = 100 * NANOS_PER_MILLI;
    /** With it the last repetition is on time, and an action that takes five seconds is still waited for. */
    private static final long MAX_TIMEOUT_NANOS = 350 * NANOS_PER_MILLI;
    private static final int ACKNOWLEDGEMENT_LENGTH = 12;

    private final Lock turn;
    private final Inbox inbox;
    private final FrameWriter writer;
    private final LineClock clock;
    private final String port;
    private final long acknowledgementNanos; // on the line
    private int sequence;
    private long longestNanos; // between the end of an action that was sent once and its outcome

    StopAndWaitSender(String port, Inbox inbox, FrameWriter writer, LineClock clock, LineSettings line) {
        this.port = port;
        this.inbox = inbox;
        this.writer = writer;
        this.clock = clock;
        turn = clock.newLock(true);
        acknowledgementNanos = ACKNOWLEDGEMENT_LENGTH * line.byteNanos();
        // another program that had the port a moment ago is unlikely to have stopped at the same number
        sequence = LastSequences.of(port, (int) Math.floorMod(clock.nanos() / NANOS_PER_MILLI, (long) Frame.SEQUENCES));
    }

    /**
     * Returns when the board has acted.
     *
     * @param timeoutMillis milliseconds to wait at most for the actions before it, and then for a turn on the line
     * @param beforeWrite done before it is written for the first time
     * @throws PortTimeoutException if its turn did not come, and then nothing was sent
     * @throws ActionRefusedException if the board does not know it, or not with these arguments
     * @throws ActionUnconfirmedException if the board has said neither
     */
    void deliver(Frame action, int timeoutMillis, FrameWriter.BeforeWrite beforeWrite) throws PortException {
        awaitTurn(timeoutMillis);
        try {
            sequence = (sequence + 1) % Frame.SEQUENCES;
            LastSequences.used(port, sequence);
            inbox.expectOutcome(sequence);
            Frame frame = action.toVersion2(Frame.ACK_WANTED, sequence);
            Inbox.Outcome outcome = repeat(frame, timeoutMillis, beforeWrite);
            if (outcome == null) {
                throw new ActionUnconfirmedException(port, "port " + port + " did not say that it acted on \"" + action.text()
                        + "\"; it may have, or the board does not run any more");
            }
            if (outcome == Inbox.Outcome.REFUSED) {
                throw new ActionRefusedException(port, "the board at port " + port + " refuses \"" + action.text()
                        + "\": it does not know the action, or not with these arguments");
            }
        } finally {
            turn.unlock();
        }
    }

    private void awaitTurn(int timeoutMillis) throws PortException {
        try {
            if (!turn.tryLock(timeoutMillis, TimeUnit.MILLISECONDS)) {
                throw new PortTimeoutException(port, "port " + port + " had no time for a message within " + timeoutMillis
                        + " ms; the board has not acknowledged the actions before it");
            }
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(port);
        }
    }

    private Inbox.Outcome repeat(Frame frame, int timeoutMillis, FrameWriter.BeforeWrite beforeWrite) throws PortException {
        long patience = timeoutNanos();
        long first = send(frame, timeoutMillis, beforeWrite);
        Inbox.Outcome outcome = await(first, patience);
        if (outcome != null) {
            longestNanos = Math.max(longestNanos, clock.nanos() - first);
        }
        for (int repeats = 0; outcome == null && repeats < REPEATS; repeats++) {
            patience *= 2;
            boolean remembered = clock.nanos() - first < LAST_REPEAT_MILLIS * NANOS_PER_MILLI;
            outcome = await(remembered ? send(frame, timeoutMillis, () -> { }) : clock.nanos(), patience);
        }
        return outcome;
    }

    private long send(Frame frame, int timeoutMillis, FrameWriter.BeforeWrite beforeWrite) throws PortException {
        return writer.write(FrameWriter.Kind.ACTION, frame, timeoutMillis, () -> {
            beforeWrite.run();
            inbox.sends(frame);
        });
    }

    private long timeoutNanos() {
        long usual = longestNanos == 0 ? FIRST_TIMEOUT_NANOS : Math.max(MIN_TIMEOUT_NANOS, 2 * longestNanos);
        return Math.min(usual, MAX_TIMEOUT_NANOS) + 2 * acknowledgementNanos;
    }

    /** Waits for the outcome, and up to twice as long while the board is saying something else. */
    private Inbox.Outcome await(long sent, long patience) throws PortException {
        Inbox.Outcome outcome = inbox.outcome(sent + patience);
        long giveUp = sent + 2 * patience;
        while (outcome == null && giveUp - clock.nanos() > 0 && clock.nanos() - inbox.lastByteNanos() < QUIET_NANOS) {
            outcome = inbox.outcome(Math.min(giveUp, inbox.lastByteNanos() + QUIET_NANOS));
        }
        return outcome;
    }
}
