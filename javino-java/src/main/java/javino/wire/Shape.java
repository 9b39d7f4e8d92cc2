package javino.wire;

import java.util.ArrayList;
import java.util.List;

/**
 * A percept's text without its digits: the pieces between the runs of digits, one more than there are runs.
 *
 * @param pieces the first in front of the first run
 */
record Shape(List<String> pieces) {
    Shape {
        pieces = List.copyOf(pieces);
    }

    /** The shape of a text, whose runs of digits are added to {@code runs}. */
    static Shape of(String text, List<String> runs) {
        List<String> pieces = new ArrayList<>();
        int from = 0;
        for (int at = 0; at < text.length(); ) {
            if (isDigit(text.charAt(at))) {
                int end = at;
                while (end < text.length() && isDigit(text.charAt(end))) {
                    end++;
                }
                pieces.add(text.substring(from, at));
                runs.add(text.substring(at, end));
                from = end;
                at = end;
            } else {
                at++;
            }
        }
        pieces.add(text.substring(from));
        return new Shape(pieces);
    }

    /** How many runs of digits a text of this shape has. */
    int runs() {
        return pieces.size() - 1;
    }

    private static boolean isDigit(char c) {
        return c >= '0' && c <= '9';
    }
}
