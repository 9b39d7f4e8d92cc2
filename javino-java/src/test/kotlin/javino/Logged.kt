package javino

import java.util.concurrent.CopyOnWriteArrayList
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger

/** Returns the messages of the logger [name] and its children during [work]. */
internal fun logged(name: String = "javino", meanwhile: () -> Unit = {}, work: () -> Unit): List<String> {
    val messages = CopyOnWriteArrayList<String>()
    val logger = Logger.getLogger(name)
    val handler = object : Handler() {
        override fun publish(record: LogRecord) {
            messages += record.message
            meanwhile()
        }

        override fun flush() = Unit

        override fun close() = Unit
    }
    logger.addHandler(handler)
    try {
        work()
    } finally {
        logger.removeHandler(handler)
    }
    return messages
}
