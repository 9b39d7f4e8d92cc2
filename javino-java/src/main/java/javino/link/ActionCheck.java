package javino.link;

import java.util.List;
import java.util.stream.Collectors;
import javino.wire.BoardAction;

/** Checks commands against the actions that a board has registered. */
final class ActionCheck {
    private static final int MAX_NAMED = 10;

    private ActionCheck() {}

    /** Returns, for a message to a person, why a board with these actions would refuse the command; null: it would not. */
    static String trouble(String command, List<BoardAction> actions) {
        if (actions.isEmpty()) {
            return null;
        }
        String functor = Command.functorOf(command);
        String name = functor.strip();
        int arguments = new Shape(command, functor.length()).arguments(command);
        BoardAction known = null;
        for (BoardAction action : actions) {
            known = action.name().equals(name) ? action : known; // the newest action of a name counts
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
     * Returns, for a message to a person, why a board has refused the command; {@code actions} is empty if the board has registered none.
     */
    static String refusal(String command, List<BoardAction> actions) {
        if (!new Shape(command, 0).isClosed()) {
            return "a bracket or quote in it is not closed";
        }
        if (actions.isEmpty()) {
            return "it does not know the action, or takes other arguments, or its program refuses the action now";
        }
        String trouble = trouble(command, actions);
        return trouble == null
                ? "it has the action, but its program refuses it now; it has " + words(actions)
                : trouble;
    }

    /** A command's text as boards read it: with three kinds of brackets, two kinds of quotes, and backslashes in double quotes. */
    private static final class Shape {
        private final int open; // the place at which the arguments begin
        private int depth;
        private int commas; // number of commas between the arguments
        private char quote; // 0: none
        private boolean isBehind; // the arguments have ended

        Shape(String command, int functorEnd) {
            open = command.startsWith("(", functorEnd) ? functorEnd : -1;
            isBehind = open < 0;
            for (int i = 0; i < command.length(); i++) {
                char c = command.charAt(i);
                if (quote == '"' && c == '\\') {
                    i++;
                } else if (quote != 0) {
                    quote = c == quote ? 0 : quote;
                } else {
                    take(c);
                }
            }
        }

        private void take(char c) {
            if (c == '"' || c == '\'') {
                quote = c;
            } else if ("([{".indexOf(c) >= 0) {
                depth++;
            } else if (")]}".indexOf(c) >= 0) {
                depth--;
                isBehind |= depth == 0;
            } else if (c == ',' && depth == 1 && !isBehind) {
                commas++;
            }
        }

        boolean isClosed() {
            return depth == 0 && quote == 0;
        }

        int arguments(String command) {
            return open < 0 || command.startsWith(")", open + 1) ? 0 : commas + 1;
        }
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
