package javino.link;

import java.util.concurrent.TimeUnit;

/**
 * Holds actions back from a version 1 board that has missed an answer, if the board has answered before. Such a board does not read, and
 * its buffer is soon full. So the board gets only requests and urgent actions until an answer comes, or for {@value #HOLD_MILLIS} ms if no
 * request follows. A board that has never answered gets its actions: it may be a board that only acts. Times are nanoseconds of one steady
 * clock. Guarded by its user's lock.
 */
final class Version1SilenceHold {
    static final int HOLD_MILLIS = 2_000;

    private boolean hasAnswered;
    private boolean isSilent;
    private long heldUntil;

    void asked(long end) {
        hold(end);
    }

    /** Records that the time for the answer to the last request is over at {@code now}. */
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

    /** Nanoseconds until actions may go out again if no answer comes; 0: they may go out now. */
    long nanosHeld(long now) {
        return isSilent && hasAnswered ? Math.max(0, heldUntil - now) : 0;
    }

    private void hold(long from) {
        heldUntil = from + TimeUnit.MILLISECONDS.toNanos(HOLD_MILLIS);
    }
}
