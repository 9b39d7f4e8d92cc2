package javino.wire;

import java.util.ArrayList;
import java.util.List;

/** A command in the form that a frame carries. */
public sealed interface CommandItem {
    /** An action without arguments, given by its number in the vocabulary: 0 to {@value CommandItem#MAX_ACTION}. */
    record Action(int number) implements CommandItem {
        public Action {
            if (number < 0 || number > MAX_ACTION) {
                throw new IllegalArgumentException("the number of an action is 0 to " + MAX_ACTION + ", not " + number);
            }
        }

        @Override
        public String payload() {
            return "" + (char) (BY_NUMBER + number);
        }
    }

    /** A command given as text, of 1 to {@value CommandItem#MAX_TEXT} bytes. */
    record Text(String text) implements CommandItem {
        public Text {
            requireLength(text);
        }

        @Override
        public String payload() {
            String length = "" + (char) text.length();
            return (text.length() < BY_NUMBER ? length : LONG_TEXT + length) + text;
        }
    }

    /** A command that sets or removes critical rules of the board, see {@link BoardRule}: 1 to {@value CommandItem#MAX_TEXT} bytes. */
    record Rule(String text) implements CommandItem {
        public Rule {
            requireLength(text);
        }

        @Override
        public String payload() {
            return "" + RULE + (char) text.length() + text;
        }
    }

    /** No command. Replaces a command whose time is over. */
    record Nothing() implements CommandItem {
        @Override
        public String payload() {
            return "" + NOTHING;
        }
    }

    /** The highest number of an action that can be called by number. */
    int MAX_ACTION = 125;

    /** Length of the longest command in bytes. */
    int MAX_TEXT = WireFrame.MAX_PAYLOAD - 2;

    /** Returns the item's bytes, one character a byte. */
    String payload();

    private static void requireLength(String text) {
        if (text.isEmpty() || text.length() > MAX_TEXT) {
            throw new IllegalArgumentException("a command has 1 to " + MAX_TEXT + " bytes, not " + text.length());
        }
    }

    /** Returns the commands of a payload, up to the first truncated or empty item. */
    static List<CommandItem> read(String payload) {
        List<CommandItem> items = new ArrayList<>();
        int at = 0;
        while (at < payload.length()) {
            char head = payload.charAt(at);
            if (head >= BY_NUMBER && head <= NOTHING) {
                items.add(head == NOTHING ? new Nothing() : new Action(head - BY_NUMBER));
                at++;
            } else {
                int lengthAt = head == LONG_TEXT || head == RULE ? at + 1 : at;
                int from = lengthAt + 1;
                int to = lengthAt < payload.length() ? from + payload.charAt(lengthAt) : Integer.MAX_VALUE;
                if (to > payload.length() || to == from) {
                    return items;
                }
                String text = payload.substring(from, to);
                items.add(head == RULE ? new Rule(text) : new Text(text));
                at = to;
            }
        }
        return items;
    }

    /** The first byte of an action by number is this value plus the number. */
    char BY_NUMBER = 0x80;
    /** The byte of {@link Nothing}. */
    char NOTHING = 0xFE;
    /** The byte before the length of a rule. */
    char RULE = 0xFF;
    /** The byte before the length of a long text. A text of 128 bytes or more needs this byte. A shorter text may also have this byte. */
    char LONG_TEXT = 0;
}
