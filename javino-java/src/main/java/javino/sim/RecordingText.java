package javino.sim;

/** How a message is written in one line of a {@link Recording}. */
final class RecordingText {
    private static final int UNICODE_DIGITS = 4;
    private static final int MAX_QUOTED = 40;

    private RecordingText() {}

    static String write(String message) {
        StringBuilder written = new StringBuilder(message.length());
        for (char c : message.toCharArray()) {
            switch (c) {
                case '\\' -> written.append("\\\\");
                case '\t' -> written.append("\\t");
                case '\n' -> written.append("\\n");
                case '\r' -> written.append("\\r");
                default -> {
                    if (Character.isISOControl(c) || Character.isSurrogate(c)) {
                        written.append(String.format("\\u%04X", (int) c));
                    } else {
                        written.append(c);
                    }
                }
            }
        }
        return written.toString();
    }

    /** @throws IllegalArgumentException if there is a backslash that begins nothing {@link #write} writes */
    static String read(String written) {
        StringBuilder message = new StringBuilder(written.length());
        int i = 0;
        while (i < written.length()) {
            char c = written.charAt(i++);
            if (c != '\\') {
                message.append(c);
                continue;
            }
            char kind = i < written.length() ? written.charAt(i++) : ' ';
            switch (kind) {
                case '\\' -> message.append('\\');
                case 't' -> message.append('\t');
                case 'n' -> message.append('\n');
                case 'r' -> message.append('\r');
                case 'u' -> {
                    message.append(unicode(written, i));
                    i += UNICODE_DIGITS;
                }
                default -> throw new IllegalArgumentException("a backslash in a message stands before \\, t, n, r or u");
            }
        }
        return message.toString();
    }

    /** {@code text} in quotes, for a message to a person: its beginning if it is long. */
    static String quoted(String text) {
        return text.length() <= MAX_QUOTED ? '"' + text + '"' : '"' + text.substring(0, MAX_QUOTED) + "...\"";
    }

    private static char unicode(String written, int at) {
        String digits = written.substring(at, Math.min(written.length(), at + UNICODE_DIGITS));
        if (!digits.matches("[0-9A-Fa-f]{4}")) {
            throw new IllegalArgumentException("\\u in a message stands before four hexadecimal digits");
        }
        return (char) Integer.parseInt(digits, 16);
    }
}
