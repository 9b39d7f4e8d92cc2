package javino.session;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.OptionalLong;

/** The commands that are out, which means sent but not acknowledged, {@value #SIZE} at most; and the frames that carry them. */
final class Window<C> {
    static final int SIZE = 16;

    static final class Entry<C> {
        final C command;
        private boolean isVoid;

        Entry(C command) {
            this.command = command;
        }

        /** Records that "no command" has gone out in this command's place. */
        void markVoid() {
            isVoid = true;
        }

        boolean isVoid() {
            return isVoid;
        }
    }

    /** A frame on its way. Its last command has the index {@code end} - 1 among those that are out. */
    private record Sent(int bytes, int end, boolean isRepeated, long leftAt) {}

    private final List<Entry<C>> out = new ArrayList<>();
    private Deque<Sent> frames = new ArrayDeque<>();
    private int oldest;
    private int unsent;
    private OptionalLong roundTrip = OptionalLong.empty();

    /** The number of the oldest command that is out; if none is out, the number of the next command. */
    int oldest() {
        return oldest;
    }

    int size() {
        return out.size();
    }

    boolean isFull() {
        return out.size() == SIZE;
    }

    /** The index of the first command that is to be sent again; {@link #size} if there is none. */
    int unsent() {
        return unsent;
    }

    Entry<C> get(int place) {
        return out.get(place);
    }

    int bytes() {
        int bytes = 0;
        for (Sent frame : frames) {
            bytes += frame.bytes;
        }
        return bytes;
    }

    /** Returns whether the board's credit allows a frame of {@code bytes} beside the frames and requests that are on their way. */
    boolean hasRoomFor(int bytes, int requestBytes, int credit) {
        return bytes() + requestBytes + bytes <= credit;
    }

    void add(C command) {
        out.add(new Entry<>(command));
    }

    /** Marks all commands that are out to be sent again. */
    void repeat() {
        unsent = 0;
        frames.clear();
    }

    void sent(int bytes, int end, boolean isRepeated, long now) {
        frames.add(new Sent(bytes, end, isRepeated, now));
        unsent = end;
    }

    /** Records when the last byte of the newest frame leaves. */
    void left(long leftAt) {
        if (!frames.isEmpty()) {
            Sent last = frames.removeLast();
            frames.add(new Sent(last.bytes, last.end, last.isRepeated, leftAt));
        }
    }

    /** Removes and returns the {@code count} oldest commands, which the board has handled by {@code now}. */
    List<Entry<C>> acknowledge(int count, long now) {
        List<Entry<C>> handled = new ArrayList<>(out.subList(0, count));
        out.subList(0, count).clear();
        oldest = oldest + count & 0xFF;
        unsent = Math.max(0, unsent - count);
        Deque<Sent> rest = new ArrayDeque<>();
        roundTrip = OptionalLong.empty();
        for (Sent frame : frames) {
            if (frame.end > count) {
                rest.add(new Sent(frame.bytes, frame.end - count, frame.isRepeated, frame.leftAt));
            } else if (!frame.isRepeated) {
                roundTrip = OptionalLong.of(now - frame.leftAt);
            }
        }
        frames = rest;
        return handled;
    }

    /** The round trip of the newest acknowledged frame that was sent only once; empty: there is none. */
    OptionalLong roundTrip() {
        return roundTrip;
    }

    /** Removes and returns all commands. The next command gets the number 0. */
    List<Entry<C>> clear() {
        List<Entry<C>> all = new ArrayList<>(out);
        out.clear();
        frames.clear();
        oldest = 0;
        unsent = 0;
        return all;
    }
}
