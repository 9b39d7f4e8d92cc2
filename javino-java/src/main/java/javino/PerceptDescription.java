package javino;

import java.util.ArrayList;
import java.util.List;

/**
 * A board's description of its kinds of percepts: {@code ?dist(front|left, cm 0..400);?ready;}.
 *
 * @param kinds the kinds, in the board's order
 * @param problems one reason for each kind that could not be read
 */
public record PerceptDescription(List<PerceptKind> kinds, List<String> problems) {
    private static final String MARK = "?";
    private static final int MAX_KINDS = 1_000;
    private static final int MAX_TEXT = 255;

    public PerceptDescription {
        kinds = List.copyOf(kinds);
        problems = List.copyOf(problems);
    }

    /** Returns the texts that describe {@code kinds}. Each text ends with {@code ;}. */
    public static List<String> texts(List<PerceptKind> kinds) {
        return kinds.stream().map(kind -> MARK + kind + ";").toList();
    }

    /** Reads an answer. A board that cannot describe its percepts answers with percepts. The result then has no kinds. */
    public static PerceptDescription read(String answer) {
        List<PerceptKind> kinds = new ArrayList<>();
        List<String> problems = new ArrayList<>();
        for (String text : PerceptTerm.split(answer)) {
            if (text.startsWith(MARK)) {
                try {
                    kinds.add(kindIn(text, kinds.size()));
                } catch (IllegalArgumentException e) {
                    problems.add(e.getMessage());
                }
            }
        }
        return new PerceptDescription(kinds, problems);
    }

    /** Returns the kind that {@code text} describes. Throws if the text is too long, or if there are too many kinds. */
    private static PerceptKind kindIn(String text, int kinds) {
        if (kinds == MAX_KINDS) {
            throw new IllegalArgumentException("a board describes at most " + MAX_KINDS + " kinds");
        }
        if (text.length() > MAX_TEXT || text.chars().anyMatch(Character::isISOControl)) {
            throw new IllegalArgumentException(
                    "a kind has at most " + MAX_TEXT + " characters, and no control character");
        }
        return PerceptKind.parse(text.substring(MARK.length()));
    }
}
