package javino.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Turns the items of an answer into text, on the computer. Keeps the {@link Shape}s of a session. Not thread-safe. */
public final class PerceptDecoder {
    private final Shape[] shapes = new Shape[PerceptItems.MAX_IDS];
    private int known;

    /** Returns the number of known shapes, counted up to the first gap. */
    public int known() {
        return known;
    }

    /** Forgets all shapes. Call this when the session has ended, or when an answer could not be read. */
    public void forget() {
        Arrays.fill(shapes, null);
        known = 0;
    }

    /**
     * Returns the text of an answer. If an item cannot be read, forgets all shapes and returns empty.
     *
     * @param items the items of all parts of the answer. A few bytes of items may make thousands of bytes of text
     * @param limit the most bytes of the text
     * @throws TooLongException if the text is longer; the shapes read so far are kept
     */
    public Optional<String> read(String items, int limit) {
        try {
            return Optional.of(new Reading(items, limit).text());
        } catch (IndexOutOfBoundsException | UnreadableException e) {
            forget();
            return Optional.empty();
        } finally {
            while (known < shapes.length && shapes[known] != null) {
                known++;
            }
        }
    }

    /** Thrown if the text of an answer is longer than the limit. */
    public static final class TooLongException extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    private static final class UnreadableException extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    /** Reads one answer. A read beyond the end shows that the answer is truncated. */
    private final class Reading {
        private final String items;
        private final int limit;
        private final StringBuilder text = new StringBuilder();
        private int at;

        Reading(String items, int limit) {
            this.items = items;
            this.limit = limit;
        }

        String text() {
            boolean isContinued = false;
            while (at < items.length()) {
                char head = items.charAt(at++);
                int count = items.charAt(at++);
                if (head < PerceptItems.DIGITS) {
                    isContinued = text(head, count, isContinued);
                } else {
                    requireReadable(!isContinued && count > 0);
                    digits(head - PerceptItems.DIGITS, count);
                }
            }
            requireReadable(!isContinued);
            return text.toString();
        }

        private boolean text(char head, int length, boolean isContinued) {
            String piece = items.substring(at, at + length);
            at += length;
            if (head < PerceptItems.MAX_IDS) {
                requireReadable(!isContinued);
                shapes[head] = Shape.of(piece);
            }
            text.append(piece);
            requireShort();
            return head == PerceptItems.CONTINUED;
        }

        private void digits(int first, int count) {
            HalfBytes digits = new HalfBytes(items, at);
            for (int id = first; id < first + count; id++) {
                requireReadable(id < shapes.length && shapes[id] != null);
                List<String> pieces = shapes[id].pieces();
                text.append(pieces.get(0));
                for (String piece : pieces.subList(1, pieces.size())) {
                    digits.appendRun(text);
                    text.append(piece);
                }
                requireShort();
            }
            at = digits.end();
        }

        private void requireShort() {
            if (text.length() > limit) {
                throw new TooLongException();
            }
        }

        private void requireReadable(boolean isReadable) {
            if (!isReadable) {
                throw new UnreadableException();
            }
        }
    }

    /** Runs of digits, two digits in a byte. */
    private static final class HalfBytes {
        private final String bytes;
        private int position; // index of the next half byte

        HalfBytes(String bytes, int from) {
            this.bytes = bytes;
            position = 2 * from;
        }

        void appendRun(StringBuilder text) {
            int before = text.length();
            for (int digit = next(); digit != PerceptItems.END_OF_RUN; digit = next()) {
                if (digit > 9) {
                    throw new UnreadableException();
                }
                text.append((char) ('0' + digit));
            }
            if (text.length() == before) {
                throw new UnreadableException();
            }
        }

        private int next() {
            char pair = bytes.charAt(position / 2);
            return position++ % 2 == 0 ? pair >> 4 : pair & 0xF;
        }

        /** Returns the index of the byte after the digits and their padding half byte. */
        int end() {
            if (position % 2 == 1 && next() != PerceptItems.END_OF_RUN) {
                throw new UnreadableException();
            }
            return position / 2;
        }
    }
}
