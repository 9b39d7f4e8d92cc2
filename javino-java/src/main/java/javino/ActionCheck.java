package javino;

import java.util.List;
import java.util.stream.Collectors;
import javino.wire.BoardAction;

/** Whether a board that has described itself knows a command. */
final class ActionCheck {
    /** How many actions a message names at most. */
    private static final int MAX_NAMED = 10;

    private ActionCheck() {}

    /** Why a board with these actions would refuse the command, for a message to a person; null: it would not. */
    static String trouble(String command, List<BoardAction> actions) {
        if (actions.isEmpty()) {
            return null;
        }
        String name = Command.functorOf(command);
        int arguments = name.length() == command.length() ? 0 : argumentsBehind(command, name.length());
        BoardAction known = null;
        for (BoardAction action : actions) {
            known = action.name().equals(name) ? action : known; // the newest counts
        }
        if (known == null) {
            return (name.isEmpty() ? "the command names no action" : "it has no action " + name) + "; it has "
                    + words(actions);
        }
        return known.arguments() == arguments || known.arguments() == BoardAction.ANY
                ? null
                : name + " takes " + count(known) + ", not " + arguments + "; the board has " + words(actions);
    }

    /** Why a board has refused the command that has told these actions, none if it has told nothing; for a message to a person. */
    static String refusal(String command, List<BoardAction> actions) {
        if (!isClosed(command)) {
            return "a bracket or quote in it is not closed";
        }
        if (actions.isEmpty()) {
            return "it does not know the action, or not with these arguments, or its program has refused what was asked now";
        }
        String trouble = trouble(command, actions);
        return trouble == null
                ? "it has the action, and its program has refused what was asked now; it has " + words(actions)
                : trouble;
    }

    /** Whether as many brackets and quotes are closed as are opened. */
    private static boolean isClosed(String command) {
        int depth = 0;
        char quote = 0; // none
        for (int i = 0; i < command.length(); i++) {
            char c = command.charAt(i);
            if (quote != 0) {
                if (c == '\\' && quote == '"') {
                    i++;
                } else if (c == quote) {
                    quote = 0;
                }
            } else if (c == '"' || c == '\'') {
                quote = c;
            } else if ("([{".indexOf(c) >= 0) {
                depth++;
            } else if (")]}".indexOf(c) >= 0) {
                depth--;
            }
        }
        return depth == 0 && quote == 0;
    }

    /** The commas outside of brackets and quotes, and one more. */
    private static int argumentsBehind(String command, int open) {
        int depth = 0;
        int arguments = command.startsWith(")", open + 1) ? 0 : 1;
        boolean isQuoted = false;
        for (int i = open + 1; i < command.length(); i++) {
            char c = command.charAt(i);
            if (c == '\\' && isQuoted) {
                i++;
            } else if (c == '"') {
                isQuoted = !isQuoted;
            } else if (!isQuoted && (c == '(' || c == '[')) {
                depth++;
            } else if (!isQuoted && (c == ')' || c == ']')) {
                depth--;
            } else if (!isQuoted && c == ',' && depth == 0) {
                arguments++;
            }
        }
        return arguments;
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
