package javino.link;

import java.util.ArrayDeque;
import java.util.Deque;
import javino.Frame;
import javino.PerceptsRequest;

/**
 * Recognizes echoes of sent frames. Some lines, such as two-wire RS-485 adapters, echo all sent bytes. A request would then pass for its
 * own answer.
 * <p>No board sends a request for percepts, so a returned request proves that the line echoes. From then on, returned actions count as
 * echoes too. Before, returned actions count as messages, because some boards send their commands back. Not thread-safe.
 */
final class LocalEchoFilter {
    /** The most frames that are remembered. Fewer frames are on their way at any time, so older frames were lost. */
    private static final int MAX = 32;

    private final Deque<Frame> sent = new ArrayDeque<>(); // frames that have not returned yet, the oldest first
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
            while (!sent.remove().equals(frame)) {} // the line has lost the frames before this one
        }
        return known;
    }
}
