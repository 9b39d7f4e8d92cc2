package javino.wire;

import java.util.ArrayList;
import java.util.List;

/**
 * A page of a board's vocabulary.
 *
 * @param request number of the answered request
 * @param first number of the page's first action
 * @param actions the actions, in the order of their numbers
 */
public record VocabularyPage(int request, int first, int total, List<BoardAction> actions) {
    private static final int HEADER = 3;

    /** The longest name of an action on a page, in bytes. */
    public static final int MAX_NAME = WireFrame.MAX_PAYLOAD - HEADER - 2;

    public VocabularyPage {
        actions = List.copyOf(actions);
    }

    /**
     * Returns the page that begins with action {@code first} of {@code all}. The page has as many actions as fit into {@code maxPayload}
     * bytes.
     */
    public static VocabularyPage of(int request, int first, List<BoardAction> all, int maxPayload) {
        List<BoardAction> fitting = new ArrayList<>();
        int length = HEADER;
        for (BoardAction action : all.subList(Math.min(first, all.size()), all.size())) {
            length += 2 + action.name().length();
            if (length > maxPayload) {
                break;
            }
            fitting.add(action);
        }
        return new VocabularyPage(request, first, all.size(), fitting);
    }

    /** Returns the page's bytes, one character a byte. */
    public String payload() {
        StringBuilder payload =
                new StringBuilder().append((char) request).append((char) first).append((char) total);
        for (BoardAction action : actions) {
            payload.append((char) action.arguments())
                    .append((char) action.name().length())
                    .append(action.name());
        }
        return payload.toString();
    }

    /** Reads a payload. Returns null if it is truncated. */
    public static VocabularyPage read(String payload) {
        if (payload.length() < HEADER) {
            return null;
        }
        List<BoardAction> actions = new ArrayList<>();
        for (int at = HEADER; at < payload.length(); ) {
            int nameAt = at + 2;
            int end = nameAt <= payload.length() ? nameAt + payload.charAt(at + 1) : Integer.MAX_VALUE;
            if (end > payload.length()) {
                return null;
            }
            actions.add(new BoardAction(payload.substring(nameAt, end), payload.charAt(at)));
            at = end;
        }
        return new VocabularyPage(payload.charAt(0), payload.charAt(1), payload.charAt(2), actions);
    }
}
