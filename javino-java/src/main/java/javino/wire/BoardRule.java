package javino.wire;

import java.util.ArrayList;
import java.util.List;

/**
 * A critical rule that a board watches itself.
 *
 * @param functor the percept's, a {@code ~} before it where it is negated
 * @param conditions all of which must be met; none: the percept itself is critical
 * @param reflex the text of the command that the board carries out when the rule begins to be met; null: none
 */
public record BoardRule(String functor, List<Condition> conditions, String reflex) {
    /** What the text of a command begins with that sets a rule. */
    public static final char MARK = 1;

    private static final char END = 0;
    private static final char REFLEX = 2;

    public BoardRule {
        conditions = List.copyOf(conditions);
    }

    /** How an argument is compared with a value. */
    public enum Operator {
        LESS('<'), GREATER('>'), AT_MOST('{'), AT_LEAST('}'), EQUAL('='), DIFFERENT('!');

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
     * @param place the argument's, 1 to 9
     * @param value a number, or the text of another term
     */
    public record Condition(int place, Operator operator, String value) {
        /** The highest place of an argument. */
        public static final int MAX_PLACE = 9;

        public Condition {
            if (place < 1 || place > MAX_PLACE) {
                throw new IllegalArgumentException("the place of an argument is 1 to " + MAX_PLACE + ", not " + place);
            }
        }
    }

    /** The text of the command that sets it as rule {@code number}, 1 to 255. */
    public String text(int number) {
        StringBuilder text = new StringBuilder().append(MARK).append((char) number).append(functor).append(END);
        for (Condition condition : conditions) {
            text.append((char) ('0' + condition.place)).append(condition.operator.sign).append(condition.value).append(END);
        }
        if (reflex != null) {
            text.append(REFLEX).append(reflex);
        }
        return text.toString();
    }

    /** The text of the command that removes rule {@code number}; 0: all rules. */
    public static String removal(int number) {
        return number == 0 ? "" + MARK : "" + MARK + (char) number;
    }

    /** The rule of a command's text; null: it sets none, or is malformed. */
    public static BoardRule read(String text) {
        int end = text.indexOf(END, 2);
        if (text.isEmpty() || text.charAt(0) != MARK || end <= 2) {
            return null;
        }
        String functor = text.substring(2, end);
        List<Condition> conditions = new ArrayList<>();
        for (int at = end + 1; at < text.length(); ) {
            if (text.charAt(at) == REFLEX) {
                return new BoardRule(functor, conditions, text.substring(at + 1));
            }
            int valueEnd = text.indexOf(END, at);
            Operator operator = valueEnd < at + 2 ? null : Operator.of(text.charAt(at + 1));
            int place = text.charAt(at) - '0';
            if (operator == null || place < 1 || place > Condition.MAX_PLACE) {
                return null;
            }
            conditions.add(new Condition(place, operator, text.substring(at + 2, valueEnd)));
            at = valueEnd + 1;
        }
        return new BoardRule(functor, conditions, null);
    }
}
