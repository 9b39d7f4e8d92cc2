package argo.recording.agent

import jason.asSemantics.TransitionSystem
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.SimpleFormatter

/** The lines that the plans of the agent of [ts] print. */
internal class PrintWatch(private val ts: TransitionSystem) : Handler() {
    private val texts = SimpleFormatter()
    private var lines = ArrayList<String>()
    private var thread: Thread? = null

    /** True if lines may have been missed: when Java ends, it takes the handlers of all loggers away while agents still reason. */
    @Volatile
    var isClosed = false
        private set

    init {
        ts.logger.addHandler(this)
    }

    /** A cycle begins, on the thread that calls. */
    fun begin() {
        thread = Thread.currentThread()
    }

    /** The lines since it was asked last. */
    fun take(): List<String> = if (lines.isEmpty()) emptyList() else lines.also { lines = ArrayList() }

    override fun publish(record: LogRecord) {
        if (Thread.currentThread() === thread && record.sourceClassName?.startsWith(JASON) != true) lines += texts.formatMessage(record)
    }

    override fun flush() = Unit

    override fun close() {
        isClosed = true
        ts.logger.removeHandler(this)
    }

    private companion object {
        /** Jason reports on an agent by the logger that plans print with. */
        val JASON: String = TransitionSystem::class.java.packageName + "."
    }
}
