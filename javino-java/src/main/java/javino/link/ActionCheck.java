package javino.link;

import java.util.List;
import java.util.stream.Collectors;
import javino.PerceptTerm;
import javino.wire.BoardAction;

/** Checks commands against the actions that a board has registered. */
final class ActionCheck {
    private static final int MAX_NAMED = 10;
    private static final String OPEN = "a bracket or quote in it is not closed";

    private ActionCheck() {}

    /**
     * Returns the reason, in words, why a board with these actions would refuse the command. Returns null if the board would take the
     * command.
     */
    static String trouble(String command, List<BoardAction> actions) {
        if (actions.isEmpty()) {
            return null;
        }
        if (!PerceptTerm.isClosed(command)) {
            return OPEN;
        }
        PerceptTerm term = PerceptTerm.of(command);
        String name = term.functor();
        int arguments = term.arguments().size();
        BoardAction known = null;
        for (BoardAction action : actions) {
            known = action.name().equals(name)
                    ? action
                    : known; // if several actions have one name, the last one counts
        }
        if (known == null) {
            return (name.isEmpty() ? "the command names no action" : "it has no action " + name) + "; it has "
                    + words(actions);
        }
        return known.arguments() == arguments || known.arguments() == BoardAction.ANY
                ? null
                : name + " takes " + count(known) + ", not " + arguments + "; the board has " + words(actions);
    }

    /**
     * Returns the likely reason, in words, why a board has refused the command.
     *
     * @param actions the board's registered actions; empty if there are none
     */
    static String refusal(String command, List<BoardAction> actions) {
        if (!PerceptTerm.isClosed(command)) {
            return OPEN;
        }
        if (actions.isEmpty()) {
            return "it does not know the action, or takes other arguments, or its program refuses the action now";
        }
        String trouble = trouble(command, actions);
        return trouble == null
                ? "it has the action, but its program refuses it now; it has " + words(actions)
                : trouble;
    }

    private static String words(List<BoardAction> actions) {
        List<String> words = actions.stream()
                .map(action -> action.name() + (action.arguments() == 0 ? "" : " with " + count(action)))
                .distinct()
                .toList();
        String named = words.stream().limit(MAX_NAMED).collect(Collectors.joining(", "));
        return words.size() > MAX_NAMED ? named + " and " + (words.size() - MAX_NAMED) + " more" : named;
    }

    private static String count(BoardAction action) {
        return switch (action.arguments()) {
            case BoardAction.ANY -> "any number of arguments";
            case 1 -> "1 argument";
            default -> action.arguments() + " arguments";
        };
    }
}
