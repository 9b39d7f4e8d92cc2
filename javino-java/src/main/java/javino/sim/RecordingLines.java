package javino.sim;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Reader;

/** The lines of a recording, or of any other file that is taken for one: none is kept that is longer than a recording's can be. */
final class RecordingLines {
    /** The most characters of a message's line: 64 KiB that are all written as {@code \}{@code u0007}, and more. */
    static final int MOST = 1 << 20;

    private static final int MOST_HEADER = 64;
    private static final int BYTE_ORDER_MARK = 0xFEFF;

    private final BufferedReader text;
    private boolean carriageReturned; // the line before ended so, and what is next may be the rest of its end

    private int number;

    RecordingLines(Reader text) {
        this.text = new BufferedReader(text);
    }

    /** The first line, without the mark that some editors put before it, or as much of it as shows that it is no header. */
    String header() throws IOException {
        number = 1;
        int character = text.read();
        return line(character == BYTE_ORDER_MARK ? text.read() : character, MOST_HEADER);
    }

    /**
     * The next line, or null; of a comment no more than its beginning.
     *
     * @throws IllegalArgumentException if it is too long
     */
    String next() throws IOException {
        number++;
        int character = text.read();
        if (carriageReturned && character == '\n') {
            character = text.read();
        }
        if (character < 0) {
            return null;
        }
        if (character == '#') {
            skip();
            return "#";
        }
        String line = line(character, MOST + 1);
        if (line.length() > MOST) {
            throw new IllegalArgumentException("a line of a recording has at most " + MOST + " characters, and this one has more");
        }
        return line;
    }

    /** Which line is being read or was read last, counted from 1. */
    int number() {
        return number;
    }

    private String line(int first, int most) throws IOException {
        StringBuilder line = new StringBuilder();
        int character = first;
        for (; !isEnd(character) && line.length() < most; character = text.read()) {
            line.append((char) character);
        }
        carriageReturned = character == '\r';
        return line.toString();
    }

    private void skip() throws IOException {
        int character = text.read();
        while (!isEnd(character)) {
            character = text.read();
        }
        carriageReturned = character == '\r';
    }

    private static boolean isEnd(int character) {
        return character < 0 || character == '\n' || character == '\r';
    }
}
