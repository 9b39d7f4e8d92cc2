package argo.tools.board

import argo.tools.command.counted
import java.util.Locale

/**
 * The rates of messages and percepts. All times are in ms since the start of monitoring. Percepts that differ only in numbers form one
 * kind. At most [MAX_KINDS] kinds are counted separately.
 */
internal class Rates {
    private val kinds = LinkedHashMap<String, Kind>()
    private val recent = ArrayDeque<Long>()

    var messages = 0L
        private set
    private var others = 0L
    private var firstMs = 0L
    private var lastMs = 0L

    private class Kind(var count: Long, var last: String)

    fun count(ms: Long, percepts: List<String>) {
        if (messages++ == 0L) firstMs = ms
        lastMs = ms
        recent.addLast(ms)
        if (recent.size > RECENT) recent.removeFirst()
        percepts.forEach(::count)
    }

    private fun count(percept: String) {
        val name = kindOf(percept)
        val kind = kinds[name] ?: if (kinds.size < MAX_KINDS) Kind(0, percept).also { kinds[name] = it } else null
        if (kind == null) others++ else kind.count++
        kind?.last = percept
    }

    /** Returns the rate of the last [RECENT] messages, in messages per second. Returns null before the second message. */
    fun now(): Double? = perSecond(recent.size.toLong(), recent.firstOrNull() ?: 0, recent.lastOrNull() ?: 0)

    fun summary(): List<String> {
        val total = "${counted(messages, "message")} in ${seconds(lastMs - firstMs)} s" + rate(messages)
        val rows = kinds.map { (name, kind) -> "  $name: ${kind.count}${rate(kind.count)}, last ${kind.last}" }
        return listOf(total) + rows + if (others == 0L) emptyList() else listOf("  $others of other kinds")
    }

    private fun rate(count: Long) = perSecond(count, firstMs, lastMs)?.let { ", ${decimal(it)} a second" }.orEmpty()

    fun kinds(): List<Triple<String, Long, String>> = kinds.map { (name, kind) -> Triple(name, kind.count, kind.last) }

    private fun perSecond(count: Long, fromMs: Long, toMs: Long): Double? =
        if (count < 2 || toMs <= fromMs) null else (count - 1) * MS_PER_S / (toMs - fromMs)

    companion object {
        const val MAX_KINDS = 200
        private const val RECENT = 10
        private const val MS_PER_S = 1000.0
        private val NUMBER_ARGUMENT = Regex("""(?<=[(,\[])\s*-?\d+(\.\d+)?([eE][+-]?\d+)?\s*(?=[,)\]])""")

        /** Returns [percept] with its numbers replaced by `_`, such as `dist(front,_)`. */
        fun kindOf(percept: String): String = NUMBER_ARGUMENT.replace(percept, "_")

        fun seconds(ms: Long): String = String.format(Locale.ROOT, "%.3f", ms / MS_PER_S)

        fun decimal(value: Double): String = String.format(Locale.ROOT, "%.1f", value)
    }
}
