package javino;

import java.util.ArrayList;
import java.util.List;

/**
 * The text of a percept or a command, taken apart into functor and arguments. No text is refused.
 *
 * @param functor the text in front of the arguments, with a {@code ~} if it is negated
 * @param arguments the texts of the arguments, without the blanks around them
 */
public record PerceptTerm(String functor, List<String> arguments) {
    public PerceptTerm {
        arguments = List.copyOf(arguments);
    }

    /**
     * Takes a percept apart. {@code text} may end with {@code ;}; text behind the arguments is ignored. {@code f()} has no arguments.
     */
    public static PerceptTerm of(String text) {
        int end = 0;
        while (end < text.length() && "([;".indexOf(text.charAt(end)) < 0) {
            end++;
        }
        boolean hasArguments = end < text.length() && text.charAt(end) == '(';
        return new PerceptTerm(withoutBlanks(text.substring(0, end)), hasArguments ? arguments(text, end) : List.of());
    }

    /** The functor and the number of arguments: {@code dist/2}. */
    public String indicator() {
        return functor + "/" + arguments.size();
    }

    /** Returns {@code text} without blanks around it. A control character is no blank. */
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

    /** The texts of an answer, each with its {@code ;}. Text behind the last {@code ;} counts as one more. */
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

    /** Returns true if every bracket and quote that opens in {@code text} is closed, and every closing bracket has an opening one. */
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

    /** Counts the open brackets outside of quotes. */
    private static final class Nesting {
        private int depth;
        private char quote; // 0: none
        private boolean isEscaped;
        private boolean hasExcess; // there was a closing bracket without an opening one

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
