package javino.session;

import javino.wire.FrameKind;
import javino.wire.WireFrame;

final class AnswerParts {
    /** An answer. The request's number is 0 if the answer came unasked. The items are null if a part is missing. */
    record Answer(int request, String items) {}

    private static final int NONE = -1;

    private final StringBuilder items = new StringBuilder();
    private int request = NONE;
    private int parts;

    /**
     * Takes a frame of percepts. Returns the answer if the frame completes the answer or shows that a part is missing. Else returns null.
     */
    Answer accept(WireFrame frame) {
        String payload = frame.payload();
        boolean isWhole = frame.kind() == FrameKind.PERCEPTS;
        if (payload.length() < (isWhole ? 1 : 2)) {
            return null;
        }
        int number = payload.charAt(0);
        if (isWhole) {
            forget();
            return new Answer(number, payload.substring(1));
        }
        if (payload.charAt(1) == 0) {
            forget();
            request = number;
        }
        if (number != request || payload.charAt(1) != parts) {
            boolean wasVoid = request == NONE && frame.kind() == FrameKind.PERCEPTS_PART;
            forget();
            return wasVoid ? null : new Answer(number, null);
        }
        parts++;
        items.append(payload, 2, payload.length());
        if (frame.kind() == FrameKind.PERCEPTS_PART) {
            return null;
        }
        Answer whole = new Answer(number, items.toString());
        forget();
        return whole;
    }

    void forget() {
        request = NONE;
        parts = 0;
        items.setLength(0);
    }
}
