package javino;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Makes messages of version 2 frames. A message of which any fragment is missing is dropped as a whole: what follows a lost fragment must
 * not be taken for a message of its own. Frames carry no start flag. A frame starts a message if its number follows that of the last
 * message's last frame; after a gap only if this board has never fragmented, and the gap is explained (lost bytes, a repeated request) or
 * the board does not number frames.
 *
 * <p>Guarded by its user's lock.
 */
final class Reassembler {
    private final int limit;
    private final ByteArrayOutputStream parts = new ByteArrayOutputStream();
    private Frame last; // the last one that came; null: none has
    private boolean gathering; // the parts so far are a message's beginning
    private boolean sendsParts;
    private boolean excused;
    private int requests; // since a message came
    private long dropped;
    private boolean tooLong;

    /** @param limit bytes that a message has at most; a longer one is dropped */
    Reassembler(int limit) {
        this.limit = limit;
    }

    /**
     * Takes the next frame.
     *
     * @param damaged whether bytes that made no frame came right before it
     * @return the text of the message that it completes, or null
     */
    String accept(Frame frame, boolean damaged) {
        Frame before = last;
        if (gathering && frame.equals(before)) {
            return null; // the line has doubled it
        }
        boolean counts = before != null && frame.sequence() == (before.sequence() + 1) % Frame.SEQUENCES;
        boolean usable = gathering ? counts : begins(frame, before, counts, damaged);
        last = frame;
        sendsParts |= frame.has(Frame.MORE);
        excused = false;
        boolean fits = parts.size() + frame.payloadLength() <= limit;
        tooLong |= usable && !fits;
        if (!usable || !fits) {
            drop();
            return null;
        }
        gathering = true;
        parts.writeBytes(frame.payload());
        return frame.has(Frame.MORE) ? null : complete();
    }

    private boolean begins(Frame frame, Frame before, boolean counts, boolean damaged) {
        if (before == null) {
            return !damaged;
        }
        if (before.has(Frame.MORE)) {
            return false; // a later part of one that was dropped
        }
        boolean known = (excused || requests > 1) && !damaged || frame.sequence() == before.sequence();
        return counts || known && !sendsParts;
    }

    private String complete() {
        String message = parts.toString(StandardCharsets.ISO_8859_1);
        gathering = false;
        parts.reset();
        requests = 0;
        tooLong = false;
        return message;
    }

    private void drop() {
        dropped++;
        gathering = false;
        parts.reset();
    }

    /** Records that a request is about to go out, so that the message which is coming in is of no use any more. */
    void asked() {
        if (gathering) {
            drop();
        }
        requests++;
    }

    /** Records that frames may have been lost before a silence. */
    void excuse() {
        excused = true;
    }

    /** Bytes that a message has at most. */
    int limit() {
        return limit;
    }

    /** Whether a message was too long, and none has come whole since. */
    boolean tooLong() {
        return tooLong;
    }

    /** Messages, or parts of them, that were dropped so far. */
    long dropped() {
        return dropped;
    }
}
