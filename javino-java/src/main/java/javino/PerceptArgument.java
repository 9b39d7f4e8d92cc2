package javino;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A board's description of one argument of a {@linkplain PerceptKind kind of percepts}. */
public sealed interface PerceptArgument {
    /** The argument may be anything: {@code _}. */
    record Anything() implements PerceptArgument {
        @Override
        public Optional<String> deviationOf(String value) {
            return Optional.empty();
        }

        @Override
        public String toString() {
            return "_";
        }
    }

    /**
     * The argument is one of several atoms or numbers: {@code front|left|right}.
     *
     * @param choices at least one
     */
    record Choice(List<String> choices) implements PerceptArgument {
        private static final Pattern ONE = Pattern.compile("[a-z][A-Za-z0-9_]*|" + Quantity.NUMBER);

        public Choice {
            choices = List.copyOf(choices);
            for (String choice : choices) {
                if (!ONE.matcher(choice).matches()) {
                    throw new IllegalArgumentException("\"" + choice + "\" is neither an atom nor a number");
                }
            }
            if (choices.isEmpty()) {
                throw new IllegalArgumentException("a choice needs something to choose from");
            }
        }

        @Override
        public Optional<String> deviationOf(String value) {
            Optional<Double> number = Quantity.numberIn(value);
            boolean isOne = choices.stream()
                    .anyMatch(choice ->
                            choice.equals(value) || number.isPresent() && number.equals(Quantity.numberIn(choice)));
            return isOne
                    ? Optional.empty()
                    : Optional.of(
                            choices.size() == 1 ? "not " + choices.get(0) : "none of " + String.join(", ", choices));
        }

        @Override
        public String toString() {
            return String.join("|", choices);
        }
    }

    /**
     * The argument is a number: {@code cm 0..400}.
     *
     * @param unit the number's unit; empty: no unit is given
     * @param min the least value; empty: there is no limit
     * @param max the greatest value; empty: there is no limit
     */
    record Quantity(String unit, Optional<BigDecimal> min, Optional<BigDecimal> max) implements PerceptArgument {
        private static final String NUMBER = "-?[0-9]{1,30}(?:\\.[0-9]{1,30})?";
        private static final String UNIT = "(?![0-9_+-])[!-~\\xa1-\\xff&&[^.,;()|#\"'\\[\\]{}]]++";
        private static final Pattern TEXT =
                Pattern.compile("(?:(" + UNIT + ") ++)?(" + NUMBER + ")? *+\\.\\. *+(" + NUMBER + ")?");
        /** The syntax of a number in a percept. */
        private static final Pattern NUMERAL = Pattern.compile("[+-]?[0-9]+(?:\\.[0-9]+)?(?:[eE][+-]?[0-9]+)?");

        public Quantity {
            if (!unit.isEmpty() && !unit.matches(UNIT)) {
                throw new IllegalArgumentException(
                        "\"" + unit + "\" is no unit: write letters or signs of ISO 8859-1, as cm, % or m/s^2");
            }
            if (min.isPresent() && max.isPresent() && min.get().compareTo(max.get()) > 0) {
                throw new IllegalArgumentException(
                        "the range begins at " + min.get().toPlainString() + " and ends before, at "
                                + max.get().toPlainString());
            }
        }

        @Override
        public Optional<String> deviationOf(String value) {
            Optional<Double> number = numberIn(value);
            if (number.isEmpty()) {
                return Optional.of("no number");
            }
            if (min.isPresent() && number.get() < min.get().doubleValue()) {
                return Optional.of("less than " + min.get().toPlainString());
            }
            return max.isPresent() && number.get() > max.get().doubleValue()
                    ? Optional.of("more than " + max.get().toPlainString())
                    : Optional.empty();
        }

        private static Optional<Double> numberIn(String value) {
            return NUMERAL.matcher(value).matches() ? Optional.of(Double.valueOf(value)) : Optional.empty();
        }

        @Override
        public String toString() {
            String range = min.map(BigDecimal::toPlainString).orElse("") + ".."
                    + max.map(BigDecimal::toPlainString).orElse("");
            return unit.isEmpty() ? range : unit + " " + range;
        }
    }

    /**
     * Returns how the text of a percept's argument deviates from this description, such as "more than 400". Returns empty if the text
     * fits.
     */
    Optional<String> deviationOf(String value);

    /**
     * Reads the description of an argument. {@link PerceptKind} defines the syntax.
     *
     * @throws IllegalArgumentException if the text cannot be read
     */
    static PerceptArgument parse(String text) {
        if (text.equals("_")) {
            return new Anything();
        }
        Matcher quantity = Quantity.TEXT.matcher(text);
        if (quantity.matches()) {
            return new Quantity(
                    Optional.ofNullable(quantity.group(1)).orElse(""),
                    Optional.ofNullable(quantity.group(2)).map(BigDecimal::new),
                    Optional.ofNullable(quantity.group(3)).map(BigDecimal::new));
        }
        try {
            return new Choice(
                    Arrays.stream(text.split("\\|", -1)).map(String::strip).toList());
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(
                    "\"" + text
                            + "\" cannot be read; write _ for anything, a choice as front|left, or a number's unit and range "
                            + "as cm 0..400",
                    e);
        }
    }
}
