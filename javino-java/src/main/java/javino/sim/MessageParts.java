package javino.sim;

import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import javino.Frame;

final class MessageParts {
    /** Matches, in this order: a rest that fits into a frame; as many whole percepts as fit; one percept that is too long. */
    private static final Pattern PART = Pattern.compile("(?s).{1,255}\\z|.{0,254};|[^;]+(;|\\z)");

    private MessageParts() {}

    /**
     * Cuts a message into one or more parts that fit into frames of version 1. Cuts only after a semicolon, even within a string. Leaves
     * out a percept that is too long for a frame.
     */
    static List<String> of(String message) {
        List<String> parts = PART.matcher(message)
                .results()
                .map(MatchResult::group)
                .filter(part -> part.length() <= Frame.MAX_PAYLOAD)
                .toList();
        return parts.isEmpty() ? List.of("") : parts;
    }
}
