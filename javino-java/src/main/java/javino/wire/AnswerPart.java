package javino.wire;

import java.util.ArrayList;
import java.util.List;

/**
 * One frame of an answer: a part or the whole answer.
 *
 * @param kind {@link FrameKind#PERCEPTS}, {@link FrameKind#PERCEPTS_PART} or {@link FrameKind#PERCEPTS_LAST}
 */
public record AnswerPart(FrameKind kind, String payload) {
    /** The most parts of an answer. */
    public static final int MAX_PARTS = 255;

    private static final int MAX_SIZE = WireFrame.MAX_PAYLOAD - 2; // without the numbers of the request and the part

    /** Returns as few frames for an answer as possible; see {@link #split(int, String, int)}. */
    public static List<AnswerPart> split(int request, String items) {
        return items.length() < WireFrame.MAX_PAYLOAD
                ? List.of(whole(request, items))
                : split(request, items, MAX_SIZE);
    }

    /**
     * Returns the frames of an answer in order.
     *
     * @param request number of the answered request; 0: none
     * @param size the most bytes of the answer in a frame. If this makes too many parts, a larger size is used
     * @throws IllegalArgumentException if the answer is longer than {@value #MAX_PARTS} frames can carry
     */
    public static List<AnswerPart> split(int request, String items, int size) {
        if (items.length() <= size) {
            return List.of(whole(request, items));
        }
        int fitting = Math.max(size, (items.length() + MAX_PARTS - 1) / MAX_PARTS);
        if (fitting > MAX_SIZE) {
            throw new IllegalArgumentException(
                    "an answer has at most " + MAX_PARTS * MAX_SIZE + " bytes, but this has " + items.length());
        }
        List<AnswerPart> parts = new ArrayList<>();
        for (int from = 0; from < items.length(); from += fitting) {
            int end = Math.min(items.length(), from + fitting);
            FrameKind kind = end < items.length() ? FrameKind.PERCEPTS_PART : FrameKind.PERCEPTS_LAST;
            parts.add(new AnswerPart(kind, "" + (char) request + (char) parts.size() + items.substring(from, end)));
        }
        return parts;
    }

    private static AnswerPart whole(int request, String items) {
        return new AnswerPart(FrameKind.PERCEPTS, (char) request + items);
    }
}
