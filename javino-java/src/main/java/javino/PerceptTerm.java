package javino;

import java.util.ArrayList;
import java.util.List;

/**
 * The functor and the arguments of a percept or a command. Any text can be read.
 *
 * @param functor the text before the arguments, with a {@code ~} if the percept is negated
 * @param arguments the texts of the arguments, without surrounding blanks
 */
public record PerceptTerm(String functor, List<String> arguments) {
    public PerceptTerm {
        arguments = List.copyOf(arguments);
    }

    /**
     * Splits a percept into functor and arguments. {@code text} may end with {@code ;}. Text after the arguments is ignored. {@code f()}
     * has no arguments.
     */
    public static PerceptTerm of(String text) {
        int end = 0;
        while (end < text.length() && "([;".indexOf(text.charAt(end)) < 0) {
            end++;
        }
        boolean hasArguments = end < text.length() && text.charAt(end) == '(';
        return new PerceptTerm(withoutBlanks(text.substring(0, end)), hasArguments ? arguments(text, end) : List.of());
    }

    /** Returns the functor and the number of arguments: {@code dist/2}. */
    public String indicator() {
        return functor + "/" + arguments.size();
    }

    /** Returns {@code text} without surrounding spaces. Keeps control characters. */
    private static String withoutBlanks(String text) {
        int from = 0;
        int end = text.length();
        while (from < end && text.charAt(from) == ' ') {
            from++;
        }
        while (from < end && text.charAt(end - 1) == ' ') {
            end--;
        }
        return text.substring(from, end);
    }

    /** Splits an answer into the texts of its percepts, each with its {@code ;}. Text after the last {@code ;} becomes one more element. */
    public static List<String> split(String answer) {
        List<String> texts = new ArrayList<>();
        Nesting nesting = new Nesting();
        int from = 0;
        for (int i = 0; i < answer.length(); i++) {
            nesting.pass(answer.charAt(i));
            if (nesting.isAt(0) && answer.charAt(i) == ';') {
                texts.add(answer.substring(from, i + 1));
                from = i + 1;
            }
        }
        if (from < answer.length()) {
            texts.add(answer.substring(from));
        }
        return texts;
    }

    /** Returns whether all brackets and quotes in {@code text} are balanced. */
    public static boolean isClosed(String text) {
        Nesting nesting = new Nesting();
        text.chars().forEach(c -> nesting.pass((char) c));
        return nesting.isAt(0) && !nesting.hasExcess;
    }

    private static List<String> arguments(String text, int bracket) {
        List<String> arguments = new ArrayList<>();
        Nesting nesting = new Nesting();
        int from = bracket + 1;
        for (int i = bracket; i < text.length(); i++) {
            nesting.pass(text.charAt(i));
            boolean ends = nesting.isAt(0);
            if (ends || nesting.isAt(1) && text.charAt(i) == ',') {
                arguments.add(withoutBlanks(text.substring(from, i)));
                from = i + 1;
            }
            if (ends) {
                break;
            }
        }
        return arguments.equals(List.of("")) ? List.of() : arguments;
    }

    private static final class Nesting {
        private int depth;
        private char quote;
        private boolean isEscaped;
        private boolean hasExcess; // there was a closing bracket without an opening bracket

        void pass(char c) {
            if (quote != 0) {
                boolean escapes = !isEscaped && c == '\\' && quote == '"';
                if (c == quote && !isEscaped) {
                    quote = 0;
                }
                isEscaped = escapes;
            } else if (c == '"' || c == '\'') {
                quote = c;
            } else if ("([{".indexOf(c) >= 0) {
                depth++;
            } else if (")]}".indexOf(c) >= 0) {
                hasExcess |= depth == 0;
                depth = Math.max(0, depth - 1);
            }
        }

        boolean isAt(int wanted) {
            return quote == 0 && depth == wanted;
        }
    }
}
