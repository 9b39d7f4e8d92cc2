package argo.ros

import java.util.concurrent.CopyOnWriteArrayList
import java.util.logging.Handler
import java.util.logging.Level
import java.util.logging.LogRecord
import java.util.logging.Logger

internal class LoggedWarnings(level: Level = Level.WARNING) : AutoCloseable {
    private val logger = Logger.getLogger("argo.ros")
    val messages = CopyOnWriteArrayList<String>()

    private val handler = object : Handler() {
        override fun publish(record: LogRecord) {
            if (record.level.intValue() >= level.intValue()) messages += record.message
        }

        override fun flush() = Unit

        override fun close() = Unit
    }.also(logger::addHandler)

    override fun close() = logger.removeHandler(handler)
}
