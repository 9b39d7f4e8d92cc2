package argo.testkit

import jason.asSemantics.TransitionSystem
import java.util.logging.ConsoleHandler
import java.util.logging.Filter
import java.util.logging.Handler
import java.util.logging.Level
import java.util.logging.LogRecord
import java.util.logging.Logger
import java.util.logging.SimpleFormatter

/** Records the log of [time], with the printed lines of its agents. */
internal class AgentLog(private val time: VirtualTime) : Handler(), AutoCloseable {
    /**
     * One record.
     *
     * @property logger the name of the logger, which ends with the agent's name
     * @property isPrinted true if a plan printed the record by `.print` or `.log`
     */
    class Entry(val atNanos: Long, val level: Level, val logger: String, val text: String, val isPrinted: Boolean) {
        fun isOf(agent: String) = logger.endsWith(".$agent")

        override fun toString() = "$level $text"
    }

    private val root = Logger.getLogger("")
    private val texts = SimpleFormatter()
    private val all = ArrayList<Entry>()

    init {
        root.addHandler(this)
        root.handlers.filterIsInstance<ConsoleHandler>().forEach { if (it.filter !is Quiet) it.filter = Quiet(it.filter) }
    }

    val entries: List<Entry> get() = all

    fun printedBy(agent: String): List<String> = all.filter { it.isPrinted && it.isOf(agent) }.map { it.text }

    override fun publish(record: LogRecord) {
        if (VirtualTime.active() !== time) return
        val text = texts.formatMessage(record) + (record.thrown?.let { " ($it)" } ?: "")
        all += Entry(time.nanos(), record.level, record.loggerName.orEmpty(), text, isPrinted(record))
    }

    /** Returns true if a plan printed [record]. Jason itself also uses the agent's logger. */
    private fun isPrinted(record: LogRecord): Boolean {
        val jason = TransitionSystem::class.java
        return record.loggerName.orEmpty().startsWith("${jason.name}.") &&
            record.sourceClassName?.startsWith("${jason.packageName}.") != true
    }

    /**
     * Hides the agents' log from the console. A failing expectation shows its own log. Logs of other tests would flood the console. The
     * property `argo.testkit.log` shows all logs if its value is `console`.
     */
    private class Quiet(private val other: Filter?) : Filter {
        override fun isLoggable(record: LogRecord): Boolean =
            (VirtualTime.active() == null || System.getProperty("argo.testkit.log") == "console") && other?.isLoggable(record) != false
    }

    override fun flush() = Unit

    override fun close() = root.removeHandler(this)
}
