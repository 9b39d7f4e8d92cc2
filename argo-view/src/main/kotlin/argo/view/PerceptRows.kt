package argo.view

import argo.filters.matching.withoutSmoothed
import argo.observing.PerceivedMessage
import javino.PerceptKind
import java.util.concurrent.TimeUnit

/**
 * The last percept of each sensor. Percepts of a board that differ only in numbers belong to one sensor. After [FORGOTTEN_NANOS] ns without
 * a percept a sensor is forgotten. If its whole board is silent, the sensor is kept. Not safe for use by several threads.
 */
internal class PerceptRows {
    private val rows = LinkedHashMap<String, Row>()
    private var port: String? = null
    private val sizes = HashMap<String, Int>() // number of percepts in the newest message, by port
    private val newest = HashMap<String, Long>() // time of the newest message, by port

    /** The time of the last byte of the newest message, by the agent's clock; null if none has come. */
    var newestNanos: Long? = null
        private set

    var moreCourses = 0
        private set

    /** Takes in the next message. If [isAlone] is true, the agent perceives no other board, and the rows of other boards are removed. */
    fun add(message: PerceivedMessage, isAlone: Boolean) {
        if (isAlone && message.portName != port) {
            rows.clear()
            sizes.clear()
            newest.clear()
        }
        port = message.portName
        newestNanos = maxOf(newestNanos ?: message.receivedNanos, message.receivedNanos)
        newest[message.portName] = message.receivedNanos
        val kept = message.kept.mapTo(HashSet(), ::withoutSmoothed)
        val standIns = (kept - message.texts.toSet()).mapTo(HashSet(), ::shape)
        val seen = HashMap<String, Int>()
        for (text in message.texts.take(MAX_ROWS)) {
            val shape = shape(text)
            val key = "${message.portName} ${shown(shape)} ${seen.merge(shape, 1, Int::plus)}"
            val before = rows[key]
            val words = shown(text)
            val since = if (before?.text == words) before.sinceNanos else message.receivedNanos
            val course = before?.course ?: RecentNumbers()
            course.add(NUMBER.findAll(words).take(MAX_NUMBERS).map { it.value.toDouble() }.toList(), message.receivedNanos)
            rows[key] = Row(message, words, fate(text, message.unreadable, kept, shape in standIns), since, course)
        }
        sizes[message.portName] = message.texts.size
        while (rows.size > MAX_ROWS) rows.remove(rows.minBy { it.value.seenNanos }.key)
    }

    private fun fate(text: String, unreadable: Set<String>, kept: Set<String>, isStoodFor: Boolean) = when {
        text in unreadable -> "unreadable"
        text in kept -> "kept"
        isStoodFor -> "held"
        else -> "dropped"
    }

    /**
     * Returns the rows at [now], in the order of the sensors' first percepts, and the number of left-out rows.
     *
     * @param kindsOf returns the kinds of percepts that the board on a port describes
     * @param isSilent returns true if nothing comes from the board on a port
     */
    fun state(
        now: Long, kindsOf: (String) -> List<PerceptKind> = { emptyList() }, isSilent: (String) -> Boolean,
    ): Pair<List<PerceptState>, Int> {
        val silent = rows.values.map { it.port }.distinct().filter(isSilent)
        fun isForgotten(port: String, nanos: Long) = (if (port in silent) newest.getValue(port) else now) - nanos > FORGOTTEN_NANOS
        rows.values.removeIf { isForgotten(it.port, it.seenNanos) }
        sizes.keys.removeIf { isForgotten(it, newest.getValue(it)) }
        val kinds = rows.values.map { it.port }.distinct().associateWith(kindsOf)
        val shown = rows.map { (key, row) ->
            val described = kinds.getValue(row.port).takeIf { it.isNotEmpty() }?.let { DescribedPercept.of(row.text, it) }
            PerceptState(
                key, row.board, row.text, row.fate, row.port in silent, ms(now - row.seenNanos), ms(now - row.sinceNanos), described,
            )
        }
        return shown to sizes.values.sum() - rows.values.count { it.seenNanos == newest[it.port] }
    }

    /** Returns the [RecentNumbers.values] of the first [MAX_COURSES] sensors with numbers, until [now], by key. */
    fun courses(now: Long): Map<String, List<List<Double?>>> {
        val all = rows.mapValues { it.value.course.values(now) }.filterValues { it.isNotEmpty() }
        moreCourses = maxOf(0, all.size - MAX_COURSES)
        return all.entries.take(MAX_COURSES).associate { it.toPair() }
    }

    private class Row(message: PerceivedMessage, val text: String, val fate: String, val sinceNanos: Long, val course: RecentNumbers) {
        val port = message.portName
        val board = message.namespace
        val seenNanos = message.receivedNanos
    }

    companion object {
        /** The time in ns for which a sensor without a new percept is shown. */
        val FORGOTTEN_NANOS: Long = TimeUnit.SECONDS.toNanos(10)
        private const val MAX_ROWS = 200
        private const val MAX_COURSES = 60
        private const val MAX_NUMBERS = 4

        private fun shape(percept: String) = percept.replace(NUMBER, "#")
    }
}
