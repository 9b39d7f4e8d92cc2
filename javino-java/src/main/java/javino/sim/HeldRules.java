package javino.sim;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javino.PerceptTerm;
import javino.wire.BoardRule;
import javino.wire.CommandItem;
import javino.wire.WireFrame;

/** The critical rules that a board watches. Not thread-safe. */
final class HeldRules {
    /** A rule that begins to match. {@code percept} is the first matching text. */
    record Beginning(int number, BoardRule rule, String percept) {}

    private static final class Watched {
        final BoardRule rule;
        boolean isMet;

        Watched(BoardRule rule) {
            this.rule = rule;
        }
    }

    private static final int MAX_PERCEPT =
            WireFrame.MAX_PAYLOAD - 2; // CRITICAL also holds a rule number and an outcome

    private final int capacity;
    private final Map<Integer, Watched> rules = new TreeMap<>(); // key: the rule's number

    HeldRules(int capacity) {
        this.capacity = capacity;
    }

    boolean isEmpty() {
        return rules.isEmpty();
    }

    void clear() {
        rules.clear();
    }

    /** Sets or removes rules according to a command. Returns false if the command is malformed or the board has no room. */
    boolean change(CommandItem.Rule command) {
        if (capacity == 0) {
            return false;
        }
        int number = command.text().charAt(0);
        if (command.text().length() == 1) {
            if (number == 0) {
                rules.clear();
            }
            rules.remove(number);
            return true;
        }
        BoardRule rule = BoardRule.read(command);
        if (rule == null || rules.size() >= capacity && !rules.containsKey(number)) {
            return false;
        }
        rules.put(number, new Watched(rule));
        return true;
    }

    /** Returns the rules that begin to match, in order of their numbers. A percept that is too long for CRITICAL matches no rule. */
    List<Beginning> look(List<String> percepts) {
        List<Beginning> beginnings = new ArrayList<>();
        rules.forEach((number, watched) -> {
            String met = percepts.stream()
                    .filter(text ->
                            text.length() <= MAX_PERCEPT && isMet(watched.rule, PerceptTerm.of(text), watched.isMet))
                    .findFirst()
                    .orElse(null);
            if (met != null && !watched.isMet) {
                beginnings.add(new Beginning(number, watched.rule, met));
            }
            watched.isMet = met != null;
        });
        return beginnings;
    }

    /**
     * Returns whether the percept matches the rule.
     *
     * @param wasMet whether the rule matched at the last look
     */
    static boolean isMet(BoardRule rule, PerceptTerm percept, boolean wasMet) {
        return percept.functor().equals(rule.functor())
                && rule.conditions().stream()
                        .allMatch(condition -> isMet(condition, valueOf(condition, wasMet), percept.arguments()));
    }

    private static String valueOf(BoardRule.Condition condition, boolean wasMet) {
        return wasMet && condition.until() != null ? condition.until() : condition.value();
    }

    private static boolean isMet(BoardRule.Condition condition, String value, List<String> arguments) {
        boolean isThere = condition.place() <= arguments.size();
        String argument = isThere ? arguments.get(condition.place() - 1) : "";
        boolean isNumber = BoardRule.isNumber(argument);
        if (!isThere || isNumber != BoardRule.isNumber(value)) {
            return condition.operator() == BoardRule.Operator.DIFFERENT;
        }
        int order = isNumber ? new BigDecimal(argument).compareTo(new BigDecimal(value)) : argument.compareTo(value);
        return switch (condition.operator()) {
            case EQUAL -> order == 0;
            case DIFFERENT -> order != 0;
            case LESS -> isNumber && order < 0;
            case GREATER -> isNumber && order > 0;
            case AT_MOST -> isNumber && order <= 0;
            case AT_LEAST -> isNumber && order >= 0;
        };
    }
}
