package javino.link;

import java.util.concurrent.TimeUnit;

/**
 * Holds actions back from a version 1 board that has answered before and has missed its last answer. Such a board does not read, and its
 * buffer is soon full. The board gets only requests and urgent actions until an answer comes. If no request follows, the hold ends after
 * {@value #HOLD_MILLIS} ms. A board that has never answered gets its actions, because it may only act. Times are nanoseconds of one
 * steady clock. Guarded by its user's lock.
 */
final class Version1SilenceHold {
    static final int HOLD_MILLIS = 2_000;

    private boolean hasAnswered;
    private boolean isSilent;
    private long heldUntil;

    void asked(long end) {
        hold(end);
    }

    void unanswered(long now) {
        isSilent = true;
        hold(now);
    }

    void heard(boolean isAnswer) {
        isSilent = false;
        hasAnswered |= isAnswer;
    }

    /** Returns whether the board has answered before, and has not missed the last answer. */
    boolean isAnswering() {
        return hasAnswered && !isSilent;
    }

    /** Returns the nanoseconds until actions may go out again if no answer comes; 0: they may go out now. */
    long nanosHeld(long now) {
        return isSilent && hasAnswered ? Math.max(0, heldUntil - now) : 0;
    }

    private void hold(long from) {
        heldUntil = from + TimeUnit.MILLISECONDS.toNanos(HOLD_MILLIS);
    }
}
