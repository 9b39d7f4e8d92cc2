package javino.link;

import java.util.ArrayDeque;
import java.util.Deque;
import javino.Frame;
import javino.PerceptsRequest;

/**
 * Tells messages of a board from the echo of its line. Some lines, such as those of two-wire RS-485 adapters, bring back all that is sent,
 * so a request would pass for its own answer.
 *
 * <p>A line turns out to be one of these when a request for percepts comes back, since no board sends one. From then on actions that come
 * back are no messages either. Before that, an action that comes back may be a message of the board, since some boards repeat their
 * commands. One thread at a time.
 */
final class LocalEchoFilter {
    /** The most frames that are remembered, more than are ever on their way: older frames were lost on the line. */
    private static final int MAX = 32;

    private final Deque<Frame> sent = new ArrayDeque<>(); // frames that have not come back yet, the oldest first
    private boolean known;

    void sends(Frame frame) {
        if (sent.size() == MAX) {
            sent.poll();
        }
        sent.add(frame);
    }

    boolean isEcho(Frame frame) {
        if (!sent.contains(frame)) {
            return false;
        }
        known |= PerceptsRequest.isIn(frame.text());
        if (known) {
            while (!sent.remove().equals(frame)) {} // the frames sent before it have been lost on the way
        }
        return known;
    }
}
