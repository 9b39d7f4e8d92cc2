package javino.wire;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * A critical rule that the board itself watches.
 *
 * @param functor the percept's functor, with a {@code ~} in front if the percept is negated
 * @param conditions conditions that must all be true; empty: each percept with the functor matches
 * @param reflex the text of the command that the board carries out when the rule begins to match; null: no command
 */
public record BoardRule(String functor, List<Condition> conditions, String reflex) {
    private static final char END = 0;
    private static final char UNTIL = 1;
    private static final char REFLEX = 2;
    private static final Pattern NUMBER = Pattern.compile("[-+]?[0-9]+(\\.[0-9]+)?");

    public BoardRule {
        conditions = List.copyOf(conditions);
    }

    /** Compares an argument with a value. */
    public enum Operator {
        LESS('<'),
        GREATER('>'),
        AT_MOST('{'),
        AT_LEAST('}'),
        EQUAL('='),
        DIFFERENT('!');

        private final char sign;

        Operator(char sign) {
            this.sign = sign;
        }

        private static Operator of(char sign) {
            for (Operator operator : values()) {
                if (operator.sign == sign) {
                    return operator;
                }
            }
            return null;
        }
    }

    /**
     * A condition on an argument.
     *
     * @param place the position of the argument, 1 to 9
     * @param value a number, or the text of another term
     * @param until the value to use while the rule matches; null: use {@code value}
     */
    public record Condition(int place, Operator operator, String value, String until) {
        /** The highest position of an argument. */
        public static final int MAX_PLACE = 9;

        public Condition {
            if (place < 1 || place > MAX_PLACE) {
                throw new IllegalArgumentException("the place of an argument is 1 to " + MAX_PLACE + ", not " + place);
            }
        }

        /** Creates a condition that always uses one value. */
        public Condition(int place, Operator operator, String value) {
            this(place, operator, value, null);
        }
    }

    /** Returns whether a command can carry the rule: the rule is short enough, and each character is a byte. */
    public boolean isSendable() {
        String text = text(1);
        return text.length() <= CommandItem.MAX_TEXT && text.chars().allMatch(c -> c <= 0xFF);
    }

    /** Returns the command that sets this rule on the board as rule {@code number}, 1 to 255. */
    public CommandItem.Rule setting(int number) {
        return new CommandItem.Rule(text(number));
    }

    private String text(int number) {
        StringBuilder text =
                new StringBuilder().append((char) number).append(functor).append(END);
        for (Condition condition : conditions) {
            text.append((char) ('0' + condition.place))
                    .append(condition.operator.sign)
                    .append(condition.value)
                    .append(condition.until == null ? "" : UNTIL + condition.until)
                    .append(END);
        }
        if (reflex != null) {
            text.append(REFLEX).append(reflex);
        }
        return text.toString();
    }

    /** Returns the command that removes rule {@code number}; 0: all rules. */
    public static CommandItem.Rule removal(int number) {
        return new CommandItem.Rule("" + (char) number);
    }

    /** Returns the rule that a command sets, or null if the command sets none or is malformed. */
    public static BoardRule read(CommandItem.Rule command) {
        String text = command.text();
        int end = text.indexOf(END, 1);
        if (end <= 1 || text.charAt(0) == 0) {
            return null;
        }
        String functor = text.substring(1, end);
        List<Condition> conditions = new ArrayList<>();
        for (int at = end + 1; at < text.length(); ) {
            if (text.charAt(at) == REFLEX) {
                return at + 1 == text.length() ? null : new BoardRule(functor, conditions, text.substring(at + 1));
            }
            int valueEnd = text.indexOf(END, at + 2);
            Condition condition = valueEnd <= at + 2 ? null : condition(text.substring(at, valueEnd));
            if (condition == null) {
                return null;
            }
            conditions.add(condition);
            at = valueEnd + 1;
        }
        return new BoardRule(functor, conditions, null);
    }

    private static Condition condition(String text) {
        int place = text.charAt(0) - '0';
        Operator operator = Operator.of(text.charAt(1));
        List<String> values = List.of(text.substring(2).split("" + UNTIL, 2));
        boolean isReadable = place >= 1
                && place <= Condition.MAX_PLACE
                && operator != null
                && values.stream().noneMatch(String::isEmpty)
                && (operator == Operator.EQUAL
                        || operator == Operator.DIFFERENT
                        || values.stream().allMatch(BoardRule::isNumber));
        return isReadable
                ? new Condition(place, operator, values.get(0), values.size() > 1 ? values.get(1) : null)
                : null;
    }

    /** Returns whether {@code text} is a number. Numbers are compared by value. */
    public static boolean isNumber(String text) {
        return NUMBER.matcher(text).matches();
    }
}
