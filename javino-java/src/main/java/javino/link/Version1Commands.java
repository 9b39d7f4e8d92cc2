package javino.link;

import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * Takes commands to a board of version 1, which acknowledges nothing: one at a time is under way, and has arrived when its last byte has
 * left. Guarded by the line's lock.
 */
final class Version1Commands {
    /** The longest time for which the device may be gone unnoticed while a long message leaves. */
    private static final long WATCH_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    private final FrameWriter writer;
    private final BooleanSupplier mustAsk;
    private Command underWay;
    private boolean isWritten; // the last byte of the command under way leaves at leavesAt
    private long leavesAt;
    private long lookAt;
    // only urgent commands went out when this one began (SilentBoardHold), so its arrival says nothing of the others
    private boolean isHeldBack;
    private boolean isUnasked; // the next command may go out although the board should be asked for something before
    private volatile long movedNanos;

    /**
     * @param now the time at which the line was opened
     * @param mustAsk whether the board has to be asked for something before it is sent a command
     */
    Version1Commands(FrameWriter writer, long now, BooleanSupplier mustAsk) {
        this.writer = writer;
        this.mustAsk = mustAsk;
        movedNanos = now;
    }

    /** The time at which a command last got through, or could begin to. */
    long movedNanos() {
        return movedNanos;
    }

    /** Records that a command can get through from {@code now} on. */
    void moved(long now) {
        movedNanos = now;
    }

    /** Returns whether the command whose turn is next waits until the board has been asked for something. */
    boolean mustAskFirst() {
        Command next = underWay == null ? writer.head() : null;
        return next != null && !isUnasked && mustAsk.getAsBoolean();
    }

    /** Lets the command whose turn is next go out although the board could not be asked. */
    void goUnasked() {
        isUnasked = writer.head() != null;
    }

    long nanosUntilBegin() {
        return underWay != null || mustAskFirst() ? Monitor.FOREVER : writer.nanosUntilCommand();
    }

    /** Nanoseconds until {@link #takeArrived} has a command, or {@link #mustLook} is true. */
    long nanosUntilArrived(long now) {
        if (!isWritten) {
            return Monitor.FOREVER;
        }
        return underWay.isOver() ? 0 : Math.max(0, Math.min(leavesAt - now, lookAt - now));
    }

    /** Begins the command whose turn has come; null: there is none. {@link #written} or {@link #takeUnderWay} follows. */
    Command begin() {
        if (nanosUntilBegin() > 0) {
            return null;
        }
        underWay = writer.head();
        isHeldBack = writer.isHeldBack();
        writer.begin();
        isUnasked = false;
        return underWay;
    }

    /** Records that a command was written by {@code now}, and when its last byte leaves. */
    void written(Command command, long left, long now) {
        if (isUnderWay(command)) {
            isWritten = true;
            leavesAt = left;
            lookAt = now + WATCH_NANOS;
        }
    }

    /** Returns whether a command is still under way, and nobody else has failed it. */
    boolean isUnderWay(Command command) {
        return command == underWay;
    }

    /** Returns whether to look now if the device is still there, for a command that takes long to leave. */
    boolean mustLook(long now) {
        boolean isTime = isWritten && lookAt - now <= 0;
        lookAt = isTime ? now + WATCH_NANOS : lookAt;
        return isTime;
    }

    /** Takes the command under way if its last byte has left by {@code now}, or nobody waits for that any more; else null. */
    Command takeArrived(long now) {
        if (!isWritten || leavesAt - now > 0 && !underWay.isOver()) {
            return null;
        }
        movedNanos = isHeldBack ? movedNanos : now;
        return takeUnderWay();
    }

    /** Takes the command under way, since it has failed; null: there is none. */
    Command takeUnderWay() {
        Command taken = underWay;
        underWay = null;
        isWritten = false;
        return taken;
    }
}
