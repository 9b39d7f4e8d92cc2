package javino.link;

import java.util.concurrent.TimeUnit;
import javino.ActionRefusedException;

/**
 * Sends commands to a board of version 1, one after the other. The board acknowledges nothing, so a command counts as arrived when its
 * last byte has left. Guarded by the line's lock.
 */
final class Version1Commands {
    /** The interval of checks for a lost device while a long message leaves. */
    private static final long WATCH_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    private final FrameWriter writer;
    private final Inbox inbox;
    private final BoardStatus board;
    private final LineReports reports;
    private final String port;
    private Command underWay;
    private boolean isWritten; // whether the command under way is written; its last byte leaves at leavesAt
    private long leavesAt;
    private long lookAt;
    // whether only urgent commands went out when this command began; its arrival then proves nothing for others
    private boolean isHeldBack;
    private boolean isUnasked; // the next command may go out without a request before it
    private boolean hasToldSlowBoard;
    private volatile long movedNanos;

    Version1Commands(FrameWriter writer, Inbox inbox, BoardStatus board, LineReports reports, String port, long now) {
        this.writer = writer;
        this.inbox = inbox;
        this.board = board;
        this.reports = reports;
        this.port = port;
        movedNanos = now;
    }

    /** Returns the time at which a command last got through, or could first get through. */
    long movedNanos() {
        return movedNanos;
    }

    void moved(long now) {
        movedNanos = now;
    }

    /** Returns whether a request or HELLO must precede the next command. */
    boolean mustAskFirst() {
        Command next = underWay == null ? writer.head() : null;
        return next != null && !isUnasked && board.mustAsk();
    }

    /**
     * Records that the board was asked. Commands may go out from {@code now} on. If the board is still not ready, at least the next
     * command may.
     */
    void hasAsked(long now) {
        if (!board.mustAsk()) {
            movedNanos = now;
        } else if (!board.hasLapsed()) {
            isUnasked = writer.head() != null;
        }
    }

    long nanosUntilBegin() {
        return underWay != null || mustAskFirst() ? Monitor.FOREVER : writer.nanosUntilCommand();
    }

    /** Returns the nanoseconds until {@link #endArrived} ends a command or {@link #mustLook} becomes true. */
    long nanosUntilArrived(long now) {
        if (!isWritten) {
            return Monitor.FOREVER;
        }
        return underWay.isOver() ? 0 : Math.max(0, Math.min(leavesAt - now, lookAt - now));
    }

    /** Returns the command that may go out now, or null. The caller then calls {@link #written} or {@link #fail}. */
    SharedLine.Outgoing next() {
        if (nanosUntilBegin() > 0) {
            return null;
        }
        underWay = writer.head();
        isHeldBack = writer.isHeldBack();
        writer.begin();
        isUnasked = false;
        if (underWay.rule() != null) {
            end(new ActionRefusedException(
                    port, "the board at port " + port + " speaks version 1, in which it takes no rules"));
            return null;
        }
        warnOfSlowBoard();
        inbox.sends(underWay.frame());
        return new SharedLine.Outgoing(underWay.frame().toBytes(), underWay);
    }

    private void warnOfSlowBoard() {
        if (writer.isBoardSlow() && !hasToldSlowBoard) {
            hasToldSlowBoard = true;
            reports.warn("the board at port " + port + " begins its answers more than " + GapEstimate.MAX_MILLIS
                    + " ms late: a board of version 1 loses commands that come while its loop() does something else;"
                    + " give the port the option spacing(Ms) with the longest time of a loop(), or use version 2");
        }
    }

    /** Records that a command was written by {@code now}. The command's last byte leaves at {@code left}. */
    void written(Command command, long left, long now) {
        if (command == underWay) { // else the command has failed already
            isWritten = true;
            leavesAt = left;
            lookAt = now + WATCH_NANOS;
        }
    }

    /** Returns whether the device must be checked now, because a command takes long to leave. */
    boolean mustLook(long now) {
        boolean isTime = isWritten && lookAt - now <= 0;
        lookAt = isTime ? now + WATCH_NANOS : lookAt;
        return isTime;
    }

    /** Ends the command under way if its last byte has left by {@code now}, or if its outcome is known. */
    void endArrived(long now) {
        if (isWritten && (leavesAt - now <= 0 || underWay.isOver())) {
            movedNanos = isHeldBack ? movedNanos : now;
            end(null);
        }
    }

    void fail(Command command, Throwable failure) {
        if (command == underWay) {
            end(failure);
        }
    }

    void abandon(Throwable failure) {
        if (underWay != null) {
            end(failure);
        }
    }

    private void end(Throwable failure) {
        reports.ended(underWay, failure);
        underWay = null;
        isWritten = false;
    }
}
