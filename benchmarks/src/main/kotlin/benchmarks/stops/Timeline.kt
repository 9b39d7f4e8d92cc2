package benchmarks.stops

import benchmarks.figures

/** Collects the events of a line and its board as text. Consecutive bytes of one sender form one entry. */
internal class Timeline(private val byteNanos: Long) {
    private class Entry(val what: String, val fromNanos: Long, var toNanos: Long, var bytes: Int)

    private val entries = ArrayList<Entry>()

    fun clear() = entries.clear()

    fun add(what: String, nanos: Long) {
        entries += Entry(what, nanos, nanos, 0)
    }

    fun addByte(sender: String, nanos: Long) {
        val last = entries.lastOrNull { it.what == sender }
        if (last == null || nanos - last.toNanos > byteNanos * 3 / 2) {
            entries += Entry(sender, nanos - byteNanos, nanos, 1)
        } else {
            last.toNanos = nanos
            last.bytes++
        }
    }

    /** Returns all events as text lines. Times are in ms after [nanos]. */
    fun since(nanos: Long): String = entries.sortedBy { it.fromNanos }.joinToString("") { entry ->
        val from = (entry.fromNanos - nanos) / NANOS_PER_MS
        val to = (entry.toNanos - nanos) / NANOS_PER_MS
        if (entry.bytes == 0) figures("%10.2f            %s\n", from, entry.what)
        else figures("%10.2f %10.2f %s, %d bytes\n", from, to, entry.what, entry.bytes)
    }

    private companion object {
        const val NANOS_PER_MS = 1e6
    }
}
