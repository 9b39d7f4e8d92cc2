package javino.sim;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;

/** One direction of a {@link MemoryLine}: the bytes and their times of arrival. Guarded by the line's lock. */
final class MemoryDirection {
    /** Signalled when bytes are put on the line or taken from it. */
    final Condition changed;

    private final byte[] bytes;
    private final long[] readyAt;
    private final long byteNanos;
    private int first;
    private int count;
    private long taken;
    private long lineFreeAt;

    MemoryDirection(int capacity, long byteNanos, Lock lock, long now) {
        bytes = new byte[capacity];
        readyAt = new long[capacity];
        this.byteNanos = byteNanos;
        changed = lock.newCondition();
        lineFreeAt = now;
    }

    /** Puts as many bytes on the line as it has room for. Returns their number. */
    int put(byte[] source, int off, int len, long now) {
        int room = Math.min(len, bytes.length - count);
        lineFreeAt += Math.max(0, now - lineFreeAt);
        for (int i = 0; i < room; i++) {
            int at = (first + count) % bytes.length;
            lineFreeAt += byteNanos;
            bytes[at] = source[off + i];
            readyAt[at] = lineFreeAt;
            count++;
        }
        return room;
    }

    /** Takes bytes that have arrived by {@code now}. Returns their number. */
    int take(byte[] target, int off, int len, long now) {
        int moved = 0;
        while (moved < len && count > 0 && readyAt[first] - now <= 0) {
            target[off + moved] = bytes[first];
            first = (first + 1) % bytes.length;
            count--;
            moved++;
        }
        taken += moved;
        return moved;
    }

    long taken() {
        return taken;
    }

    int room() {
        return bytes.length - count;
    }

    boolean isEmpty() {
        return count == 0;
    }

    void clear() {
        count = 0;
    }

    /** Returns the nanoseconds until the next byte arrives, or {@link Long#MAX_VALUE} if none is on its way. */
    long nanosUntilReady(long now) {
        return count == 0 ? Long.MAX_VALUE : Math.max(1, readyAt[first] - now);
    }
}
