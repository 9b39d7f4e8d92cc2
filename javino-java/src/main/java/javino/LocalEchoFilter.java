package javino;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Tells what a board says from what its line brings back. On some lines, as those of two-wire RS-485 adapters, all that is sent is received
 * as well, so a request would pass for its own answer.
 *
 * <p>That a line is one of these shows when a request for percepts comes back, which no board says. From then on actions that come back
 * are no messages either; before, one may be a board's own: some say what they were told. One thread at a time.
 */
final class LocalEchoFilter {
    /** More than are ever on their way: the others were lost on it. */
    private static final int MAX = 32;

    private final Deque<Frame> sent = new ArrayDeque<>(); // what has not come back yet, the oldest first
    private boolean known;

    /** Records that a frame is about to go out. */
    void sends(Frame frame) {
        if (sent.size() == MAX) {
            sent.poll();
        }
        sent.add(frame);
    }

    /** Whether a frame that came is one that was sent. */
    boolean isEcho(Frame frame) {
        if (!sent.contains(frame)) {
            return false;
        }
        known |= PerceptsRequest.isIn(frame.text());
        if (known) {
            while (!sent.remove().equals(frame)) {} // what was sent before it has been lost on the way
        }
        return known;
    }
}
