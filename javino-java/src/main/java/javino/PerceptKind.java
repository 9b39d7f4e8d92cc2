package javino;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * A kind of a board's percepts: {@code dist(front|left|right, cm 0..400)}.
 *
 * <p>Boards of version 2 report their kinds in this form. A file of percepts has one kind a line.
 *
 * <table>
 * <caption>Arguments</caption>
 * <tr><th>text</th><th>value in percepts</th></tr>
 * <tr><td>{@code _}</td><td>anything</td></tr>
 * <tr><td>{@code front|left}, {@code 0|1}, {@code sonar}</td><td>one of these atoms or numbers</td></tr>
 * <tr><td>{@code 0..400}, {@code -0.5..}, {@code ..}</td><td>a number in this range; a limit may be missing</td></tr>
 * <tr><td>{@code cm 0..400}, {@code % ..}</td><td>a number in this range and this unit</td></tr>
 * </table>
 *
 * @param functor the percepts' functor, with a {@code ~} in front if the percepts are strongly negated
 * @param arguments one description for each argument, in order
 */
public record PerceptKind(String functor, List<PerceptArgument> arguments) {
    private static final Pattern FUNCTOR = Pattern.compile("~?[a-z][A-Za-z0-9_]*");
    private static final Pattern TEXT = Pattern.compile("([^( ;]*+) *+(?:\\((.*)\\))? *+;?", Pattern.DOTALL);

    public PerceptKind {
        arguments = List.copyOf(arguments);
        if (!FUNCTOR.matcher(functor).matches()) {
            throw new IllegalArgumentException(
                    "\"" + functor
                            + "\" is no functor: write a letter from a to z, then letters, digits and _, as in dist(cm 0..400)");
        }
    }

    /**
     * Reads the text of one kind. The text may end with {@code ;}.
     *
     * @throws IllegalArgumentException if the text cannot be read; the message says where, and what is allowed
     */
    public static PerceptKind parse(String text) {
        var parts = TEXT.matcher(text.strip());
        if (!parts.matches()) {
            throw new IllegalArgumentException(
                    "\"" + text
                            + "\" describes no percepts: write a functor, and its arguments in brackets, as in dist(cm 0..400)");
        }
        List<PerceptArgument> arguments = new ArrayList<>();
        if (parts.group(2) != null) {
            for (String argument : parts.group(2).split(",", -1)) {
                arguments.add(argumentOf(argument.strip(), arguments.size() + 1, text));
            }
        }
        return new PerceptKind(parts.group(1), arguments);
    }

    private static PerceptArgument argumentOf(String argument, int place, String text) {
        try {
            return PerceptArgument.parse(argument);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("argument " + place + " of " + text.strip() + ": " + e.getMessage(), e);
        }
    }

    /**
     * Reads a file of percepts: one kind a line. A {@code #} begins a comment.
     *
     * @throws IllegalArgumentException if a line cannot be read; the message has the line's number, counted from 1
     */
    public static List<PerceptKind> parseLines(String file) {
        List<PerceptKind> kinds = new ArrayList<>();
        String[] lines = file.split("\\R");
        for (int i = 0; i < lines.length; i++) {
            String kind = lines[i].replaceFirst("#.*", "").strip();
            if (!kind.isEmpty()) {
                try {
                    kinds.add(parse(kind));
                } catch (IllegalArgumentException e) {
                    throw new IllegalArgumentException("line " + (i + 1) + ": " + e.getMessage(), e);
                }
            }
        }
        return kinds;
    }

    /**
     * Returns why a percept does not belong to this kind, such as "argument 2 is 512, more than 400". Returns empty if the percept
     * belongs.
     */
    public Optional<String> deviationOf(PerceptTerm percept) {
        if (!isAlike(percept)) {
            return Optional.of(percept.indicator() + " is not " + functor + "/" + arguments.size());
        }
        for (int i = 0; i < arguments.size(); i++) {
            String given = percept.arguments().get(i);
            Optional<String> deviation = arguments.get(i).deviationOf(given);
            if (deviation.isPresent()) {
                return Optional.of("argument " + (i + 1) + " is " + given + ", " + deviation.get());
            }
        }
        return Optional.empty();
    }

    /**
     * Returns the first of {@code kinds} that fits the percept. If none fits, returns the first with the percept's functor and number of
     * arguments.
     */
    public static Optional<PerceptKind> of(PerceptTerm percept, List<PerceptKind> kinds) {
        List<PerceptKind> alike =
                kinds.stream().filter(kind -> kind.isAlike(percept)).toList();
        return alike.stream()
                .filter(kind -> kind.deviationOf(percept).isEmpty())
                .findFirst()
                .or(() -> alike.stream().findFirst());
    }

    /**
     * Returns why a percept belongs to none of {@code kinds}. Returns empty if the percept belongs to one of them. If only one kind has
     * the percept's functor and number of arguments, the reason tells how the percept deviates from this kind. If several kinds have
     * these, the reason names the kinds.
     */
    public static Optional<String> deviationOf(PerceptTerm percept, List<PerceptKind> kinds) {
        List<PerceptKind> alike =
                kinds.stream().filter(kind -> kind.isAlike(percept)).toList();
        if (alike.stream().anyMatch(kind -> kind.deviationOf(percept).isEmpty())) {
            return Optional.empty();
        }
        return switch (alike.size()) {
            case 0 -> Optional.of("no " + percept.indicator() + " is described");
            case 1 -> alike.get(0).deviationOf(percept);
            default ->
                Optional.of("it is none of "
                        + alike.stream().map(PerceptKind::toString).collect(Collectors.joining(" and ")));
        };
    }

    /**
     * Returns a percept's text for a person, with units after numbers: {@code dist(front,38 cm)}. The percept has this kind's functor and
     * number of arguments.
     */
    public String withUnits(PerceptTerm percept) {
        List<String> shown = new ArrayList<>();
        for (int i = 0; i < arguments.size(); i++) {
            String unit = arguments.get(i) instanceof PerceptArgument.Quantity quantity ? quantity.unit() : "";
            shown.add(
                    unit.isEmpty()
                            ? percept.arguments().get(i)
                            : percept.arguments().get(i) + " " + unit);
        }
        return shown.isEmpty() ? functor : functor + "(" + String.join(",", shown) + ")";
    }

    /** Returns whether a percept has the functor and the number of arguments of this kind. */
    public boolean isAlike(PerceptTerm percept) {
        return percept.functor().equals(functor) && percept.arguments().size() == arguments.size();
    }

    /** Returns the kind's text in the syntax of {@link #parse}. */
    @Override
    public String toString() {
        return arguments.isEmpty()
                ? functor
                : arguments.stream().map(Object::toString).collect(Collectors.joining(", ", functor + "(", ")"));
    }
}
