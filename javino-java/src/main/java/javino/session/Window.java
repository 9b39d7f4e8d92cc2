package javino.session;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.OptionalLong;

/** The commands that were sent but not acknowledged, {@value #SIZE} at most, and the frames that carry them. */
final class Window<C> {
    static final int SIZE = 16;

    static final class Entry<C> {
        final C command;
        /** Whether {@link CommandItem.Nothing} was sent in place of this command. */
        boolean isVoid;

        Entry(C command) {
            this.command = command;
        }
    }

    /** A frame on its way. {@code end} is the index after its last command. */
    private record Sent(int bytes, int end, boolean isRepeated, long leftAt) {}

    private final List<Entry<C>> out = new ArrayList<>();
    private Deque<Sent> frames = new ArrayDeque<>();
    private int oldest;
    private int unsent;
    private OptionalLong roundTrip = OptionalLong.empty();

    /** Returns the number of the oldest unacknowledged command. If there is none, returns the number of the next command. */
    int oldest() {
        return oldest;
    }

    int size() {
        return out.size();
    }

    boolean isFull() {
        return out.size() == SIZE;
    }

    /** Returns the index of the first command to send again, or {@link #size} if there is none. */
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

    /** Returns whether the board's credit allows another frame of {@code bytes}. */
    boolean hasRoomFor(int bytes, int requestBytes, int credit) {
        return bytes() + requestBytes + bytes <= credit;
    }

    void add(C command) {
        out.add(new Entry<>(command));
    }

    /** Marks all unacknowledged commands to be sent again. */
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

    /** Removes and returns the {@code count} oldest commands. The board has handled these commands by {@code now}. */
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

    /** Returns the round trip of the newest acknowledged frame, if that frame was sent only once. */
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
