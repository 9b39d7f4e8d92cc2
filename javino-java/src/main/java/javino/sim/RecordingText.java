package javino.sim;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Writes a message as a part of one line of a {@link LineRecording}, and reads it back. */
final class RecordingText {
    private static final Pattern SPECIAL = Pattern.compile("[\\\\\\p{Cc}\\p{Cs}]");
    private static final Pattern ESCAPE = Pattern.compile("\\\\(u\\p{XDigit}{4}|.?)");

    private RecordingText() {}

    static String write(String message) {
        return SPECIAL.matcher(message)
                .replaceAll(special -> Matcher.quoteReplacement(
                        switch (special.group()) {
                            case "\\" -> "\\\\";
                            case "\t" -> "\\t";
                            case "\n" -> "\\n";
                            case "\r" -> "\\r";
                            default ->
                                String.format("\\u%04X", (int) special.group().charAt(0));
                        }));
    }

    /** @throws IllegalArgumentException if a backslash begins none of the escapes of {@link #write} */
    static String read(String written) {
        return ESCAPE.matcher(written).replaceAll(escape -> Matcher.quoteReplacement(character(escape.group(1))));
    }

    private static String character(String kind) {
        return switch (kind) {
            case "\\" -> "\\";
            case "t" -> "\t";
            case "n" -> "\n";
            case "r" -> "\r";
            case "u" -> throw new IllegalArgumentException("\\u in a message stands before four hexadecimal digits");
            default -> {
                if (kind.length() < 2) {
                    throw new IllegalArgumentException("a backslash in a message stands before \\, t, n, r or u");
                }
                yield Character.toString(Integer.parseInt(kind.substring(1), 16));
            }
        };
    }
}
