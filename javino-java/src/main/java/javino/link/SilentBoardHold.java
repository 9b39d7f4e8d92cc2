package javino.link;

import java.util.concurrent.TimeUnit;

/**
 * Holds actions back from a version 1 board that has answered before and has not answered the last request in time. Until an answer comes,
 * or for {@value #HOLD_MILLIS} ms if the board is not asked again, the board gets requests and only urgent actions: it does not read, and
 * its buffer is soon full. A board that has never answered may be one that only acts. Times are nanoseconds of one steady clock. Guarded by
 * its user's lock.
 */
final class SilentBoardHold {
    /** The time for which actions are held back behind the last request that was not answered. */
    static final int HOLD_MILLIS = 2_000;

    private boolean hasAnswered;
    private boolean isSilent; // the board has not answered the last request in time
    private long heldUntil;

    /** Records that the last byte of a request leaves at {@code end}. */
    void asked(long end) {
        hold(end);
    }

    /** Records that the last request has not been answered in its time, which is over at {@code now}. */
    void unanswered(long now) {
        isSilent = true;
        hold(now);
    }

    /** Records that a message is complete: an answer, if one was awaited. */
    void heard(boolean isAnswer) {
        isSilent = false;
        hasAnswered |= isAnswer;
    }

    /** Returns whether the board has answered before, and has not failed to answer the last request in time. */
    boolean isAnswering() {
        return hasAnswered && !isSilent;
    }

    /** Nanoseconds until actions are held back no more if no answer comes; 0: they are not held back. */
    long nanosHeld(long now) {
        return isSilent && hasAnswered ? Math.max(0, heldUntil - now) : 0;
    }

    private void hold(long from) {
        heldUntil = from + TimeUnit.MILLISECONDS.toNanos(HOLD_MILLIS);
    }
}
