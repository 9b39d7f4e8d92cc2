package argo.recording.agent

import jason.asSemantics.TransitionSystem
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.SimpleFormatter

/** Collects the lines that the plans of the agent of [ts] print. */
internal class PrintWatch(private val ts: TransitionSystem) : Handler() {
    private val texts = SimpleFormatter()
    private var lines = ArrayList<String>()
    private var thread: Thread? = null

    /** True if lines may be missing. When Java ends, it removes the handlers of all loggers while agents still reason. */
    @Volatile
    var isClosed = false
        private set

    init {
        ts.logger.addHandler(this)
    }

    fun begin() {
        thread = Thread.currentThread()
    }

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
        /** The prefix of Jason's own classes, which use the logger of the agent's plans. */
        val JASON: String = TransitionSystem::class.java.packageName + "."
    }
}
