package javino.wire;

import java.util.ArrayList;
import java.util.List;

/**
 * A percept's text without its digits: the pieces between the runs of digits. All values of one sensor usually have one shape.
 *
 * @param pieces the texts before, between and after the runs of the digits 0 to 9; each may be empty. The number of pieces is the number
 *     of runs plus 1
 */
public record Shape(List<String> pieces) {
    public Shape {
        pieces = List.copyOf(pieces);
    }

    /** Returns the shape of a text. */
    public static Shape of(String text) {
        return of(text, new ArrayList<>());
    }

    /**
     * Returns the shape of a text.
     *
     * @param runs receives the text's runs of digits, in order
     */
    public static Shape of(String text, List<String> runs) {
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

    private static boolean isDigit(char c) {
        return c >= '0' && c <= '9';
    }
}
