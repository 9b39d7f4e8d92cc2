package javino.sim;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.LineNumberReader;
import java.io.Reader;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import javino.Frame;
import javino.PerceptsRequest;

/**
 * The messages of a line in order, with their times. Immutable.
 *
 * <p>A recording's file is UTF-8 text. The first line is {@code javino-recording 1}. Each message has a line
 * {@code <ms>\t<in|out|critical|reflex>\t<message>}. In a message, {@code \\}, {@code \t}, {@code \n} and {@code \r} stand for a
 * backslash, a tab and line ends. Other control characters have the form <code>&#92;u0007</code>. Empty lines and lines that begin with
 * {@code #} are ignored. {@link RecordingWriter} writes such files.
 *
 * @param entries the messages, with times in ascending order
 */
public record LineRecording(List<Entry> entries) {
    static final String HEADER = "javino-recording 1";

    private static final String HEADER_WORD = "javino-recording ";
    private static final int MAX_HEADER = 64;

    /** The direction of a message. */
    public enum Direction {
        /** From the board. */
        IN,

        /** To the board. */
        OUT,

        /** From the board, unasked: the percept that matched one of the board's critical rules. */
        CRITICAL,

        /** The reflex of a critical rule: a command that the board carried out on its own. */
        REFLEX;

        final String word = name().toLowerCase(Locale.ROOT);
    }

    /**
     * One message.
     *
     * @param millis milliseconds since the recording began, at least 0
     * @param message the message's text, one character a byte
     */
    public record Entry(long millis, Direction direction, String message) {
        /** @throws IllegalArgumentException if the time is negative, or a character of the message is above U+00FF */
        public Entry {
            if (millis < 0) {
                throw new IllegalArgumentException(
                        "a recording begins at 0 ms, but a message at " + millis + " ms was given");
            }
            Frame.requireBytes(message);
        }
    }

    /** @throws IllegalArgumentException if an entry is earlier than the previous entry */
    public LineRecording {
        entries = List.copyOf(entries);
        for (int i = 1; i < entries.size(); i++) {
            if (entries.get(i).millis() < entries.get(i - 1).millis()) {
                throw new IllegalArgumentException("message " + (i + 1) + " of a recording is at "
                        + entries.get(i).millis() + " ms, which is before the one in front of it");
            }
        }
    }

    /** Returns the messages from the board with all its percepts: answers, and messages sent unasked. */
    public List<Entry> received() {
        return entries.stream()
                .filter(entry -> entry.direction() == Direction.IN)
                .toList();
    }

    /** Returns whether the board sent its percepts in answer to requests. */
    public boolean isOfRequests() {
        return entries.stream()
                .anyMatch(entry -> entry.direction() == Direction.OUT && PerceptsRequest.isIn(entry.message()));
    }

    /**
     * Reads a file.
     *
     * @throws java.nio.file.FileSystemException if the file cannot be read
     * @throws IOException also if the file is no recording; the message names the file, the line and the fault
     */
    public static LineRecording read(Path file) throws IOException {
        try (BufferedReader reader = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
            return read(reader, file.toString());
        }
    }

    /** Like {@link #read(Path)}, but reads {@code text}. Error messages use {@code source} as its name. Does not close the reader. */
    public static LineRecording read(Reader text, String source) throws IOException {
        LineNumberReader lines = new LineNumberReader(text);
        List<Entry> entries = new ArrayList<>();
        try {
            requireHeader(lines);
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                if (!line.isEmpty() && !line.startsWith("#")) {
                    entries.add(entry(
                            line,
                            entries.isEmpty()
                                    ? 0
                                    : entries.get(entries.size() - 1).millis()));
                }
            }
        } catch (CharacterCodingException e) {
            throw new IOException(source + ": bytes that are not UTF-8", e);
        } catch (IllegalArgumentException e) {
            throw new IOException(source + ":" + Math.max(1, lines.getLineNumber()) + ": " + e.getMessage(), e);
        }
        return new LineRecording(entries);
    }

    /** Checks the first line. Reads only as many characters as a header has, because a wrong file may be endless. */
    private static void requireHeader(LineNumberReader text) throws IOException {
        char[] beginning = new char[MAX_HEADER];
        text.mark(MAX_HEADER);
        int count = Math.max(0, text.read(beginning));
        text.setLineNumber(1); // errors must name the first line
        // without the byte order mark of an editor
        String line =
                new String(beginning, 0, count).lines().findFirst().orElse("").replaceFirst("^\\uFEFF", "");
        if (line.startsWith(HEADER_WORD) && !line.equals(HEADER)) {
            throw new IllegalArgumentException("a recording of format " + line.substring(HEADER_WORD.length())
                    + "; only format 1 can be read here");
        }
        if (!HEADER.equals(line)) {
            throw new IllegalArgumentException("the first line of a recording is \"" + HEADER + "\"");
        }
        text.reset();
        text.readLine();
    }

    private static Entry entry(String line, long earliest) {
        String[] fields = line.split("\t", 3);
        if (fields.length < 3) {
            throw new IllegalArgumentException(
                    "a message is written MILLISECONDS, a tab, \"in\" or \"out\", a tab, and its text");
        }
        long millis = millis(fields[0]);
        if (millis < earliest) {
            throw new IllegalArgumentException(
                    "a message at " + millis + " ms stands behind one at " + earliest + " ms");
        }
        return new Entry(millis, direction(fields[1]), RecordingText.read(fields[2]));
    }

    private static long millis(String written) {
        if (!written.matches("[0-9]{1,18}")) {
            throw new IllegalArgumentException(Frame.quoted(written) + " is not a time in whole milliseconds");
        }
        return Long.parseLong(written);
    }

    private static Direction direction(String written) {
        return Arrays.stream(Direction.values())
                .filter(direction -> direction.word.equals(written))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(Frame.quoted(written)
                        + " is no direction; a message goes \"in\" or \"out\", or is \"critical\" or a \"reflex\""));
    }
}
