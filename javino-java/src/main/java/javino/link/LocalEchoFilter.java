package javino.link;

import java.util.ArrayDeque;
import java.util.Deque;
import javino.Frame;
import javino.PerceptsRequest;

/**
 * Tells messages of a board from the echo of its line. Some lines, such as two-wire RS-485 adapters, echo everything that is sent, so a
 * request would pass for its own answer.
 * <p>No board sends a request for percepts, so a request that comes back proves that the line echoes. From then on, actions that come back
 * are no messages either. Before, they count as messages, since some boards send their commands back. One thread at a time.
 */
final class LocalEchoFilter {
    /** The most frames that are remembered: fewer are on their way at any time, so older frames were lost on the line. */
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
            while (!sent.remove().equals(frame)) {} // the line has lost the frames sent before this one
        }
        return known;
    }
}
