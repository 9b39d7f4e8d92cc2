package argo.testkit

import jason.asSemantics.TransitionSystem
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger
import java.util.logging.SimpleFormatter

/** What is logged while [time] is driven, and with it what an agent prints. */
internal class AgentLog(private val time: VirtualTime) : Handler(), AutoCloseable {
    private val root = Logger.getLogger("")
    private val texts = SimpleFormatter()

    /** Level, the last part of the logger's name, and message; in the order of logging. */
    val lines = ArrayList<String>()

    /** What the agent printed. */
    val printed = ArrayList<String>()

    init {
        root.addHandler(this)
    }

    override fun publish(record: LogRecord) {
        if (VirtualTime.active() !== time) return
        val text = texts.formatMessage(record) + (record.thrown?.let { " ($it)" } ?: "")
        lines += "${record.level} $text"
        if (record.loggerName?.startsWith(TransitionSystem::class.java.name) == true) printed += text
    }

    override fun flush() = Unit

    override fun close() = root.removeHandler(this)
}
