package argo.view

import kotlinx.serialization.Serializable
import java.util.logging.Formatter
import java.util.logging.Handler
import java.util.logging.Level
import java.util.logging.LogRecord
import java.util.logging.SimpleFormatter

/**
 * The last lines of an agent's log. Safe for use by several threads. A printing thread waits only until its line is noted.
 *
 * @param nanos a clock in ns that never goes back
 * @param changed called after each line
 */
internal class LogLines(private val nanos: () -> Long, private val changed: () -> Unit) : Handler() {
    private val lines = ArrayDeque<Line>()
    private val words: Formatter = SimpleFormatter()
    private var count = 0L

    override fun publish(record: LogRecord) {
        if (!isLoggable(record)) return
        val text = shown(words.formatMessage(record).orEmpty() + record.thrown?.let { " $it" }.orEmpty())
        synchronized(lines) { add(text, record.level) }
        changed()
    }

    private fun add(text: String, level: Level) {
        val last = lines.lastOrNull()
        if (last != null && last.text == text && last.level == level) {
            last.times++
            last.nanos = nanos()
            return
        }
        if (lines.size == MAX_LINES) lines.removeFirst()
        lines += Line(++count, text, level, nanos())
    }

    fun state(now: Long): List<LineState> = synchronized(lines) {
        lines.asReversed().map { LineState(it.number, it.text, it.times, it.isWarning, ms(now - it.nanos)) }
    }

    override fun flush() = Unit

    override fun close() = Unit

    private class Line(val number: Long, val text: String, val level: Level, var nanos: Long) {
        val isWarning = level.intValue() >= Level.WARNING.intValue()
        var times = 1
    }

    private companion object {
        const val MAX_LINES = 50
    }
}

/**
 * A line that an agent has printed, or that Jason has logged about it.
 *
 * @property times how many times in a row the line has come
 * @property warning whether it is a warning or worse
 * @property ageMs ms since the line last came
 */
@Serializable
internal data class LineState(val number: Long, val text: String, val times: Int, val warning: Boolean, val ageMs: Long)
