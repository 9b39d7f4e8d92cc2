package javino.wire;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Turns percepts into the items of an answer, on the board. Numbers the {@link Shape}s of a session. Not thread-safe. */
public final class PerceptWriter {
    private final int capacity;
    private final Map<Shape, Integer> ids = new HashMap<>();

    /** @param capacity number of shapes that the board can number, 0 to 126 */
    public PerceptWriter(int capacity) {
        this.capacity = Math.min(capacity, PerceptItems.MAX_IDS);
    }

    /** Returns the number of shapes that have a number in this session. */
    public int numbered() {
        return ids.size();
    }

    /** Forgets all shapes. Call this when a session begins. */
    public void forget() {
        ids.clear();
    }

    /**
     * Returns the items of an answer.
     *
     * @param percepts texts, each with its {@code ;}
     * @param known number of shapes that the computer knows
     */
    public String items(List<String> percepts, int known) {
        StringBuilder items = new StringBuilder();
        Row row = new Row(items);
        for (String percept : percepts) {
            List<String> runs = new ArrayList<>();
            Shape shape = Shape.of(percept, runs);
            Integer id = ids.get(shape);
            if (id != null && id < known) {
                row.add(id, runs);
            } else {
                row.end();
                putText(items, percept, id != null ? id : number(shape, percept));
            }
        }
        row.end();
        return items.toString();
    }

    /** Returns the items of texts without shape ids, such as a description. */
    public static String itemsWithoutIds(List<String> texts) {
        StringBuilder items = new StringBuilder();
        texts.forEach(text -> putText(items, text, PerceptItems.NO_ID));
        return items.toString();
    }

    /** Returns the id of a new shape. If no id is left, returns {@link PerceptItems#NO_ID}. */
    private int number(Shape shape, String percept) {
        if (ids.size() >= capacity || percept.length() > PerceptItems.MAX_LENGTH) {
            return PerceptItems.NO_ID;
        }
        ids.put(shape, ids.size());
        return ids.size() - 1;
    }

    private static void putText(StringBuilder items, String text, int id) {
        String rest = text;
        for (; rest.length() > PerceptItems.MAX_LENGTH; rest = rest.substring(PerceptItems.MAX_LENGTH)) {
            items.append(PerceptItems.CONTINUED)
                    .append((char) PerceptItems.MAX_LENGTH)
                    .append(rest, 0, PerceptItems.MAX_LENGTH);
        }
        items.append((char) (text.length() > PerceptItems.MAX_LENGTH ? PerceptItems.NO_ID : id))
                .append((char) rest.length())
                .append(rest);
    }

    /** A row of percepts with consecutive ids, sent as digits only. */
    private static final class Row {
        private final StringBuilder items;
        private final StringBuilder halfBytes = new StringBuilder(); // each character is a half byte
        private int first;
        private int count;

        Row(StringBuilder items) {
            this.items = items;
        }

        void add(int id, List<String> runs) {
            if (count > 0 && (id != first + count || count == PerceptItems.MAX_LENGTH)) {
                end();
            }
            if (count++ == 0) {
                first = id;
            }
            for (String run : runs) {
                run.chars().forEach(digit -> halfBytes.append((char) (digit - '0')));
                halfBytes.append((char) PerceptItems.END_OF_RUN);
            }
        }

        void end() {
            if (count == 0) {
                return;
            }
            items.append((char) (PerceptItems.DIGITS + first)).append((char) count);
            if (halfBytes.length() % 2 == 1) {
                halfBytes.append((char) PerceptItems.END_OF_RUN);
            }
            for (int i = 0; i < halfBytes.length(); i += 2) {
                items.append((char) (halfBytes.charAt(i) << 4 | halfBytes.charAt(i + 1)));
            }
            halfBytes.setLength(0);
            count = 0;
        }
    }
}
