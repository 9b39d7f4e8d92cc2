package samples.project

import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.logging.Formatter
import java.util.logging.Level
import java.util.logging.LogManager
import java.util.logging.LogRecord
import java.util.logging.Logger
import java.util.logging.StreamHandler

/** The log of Jason, ARGO and the agents during a run. Each entry is one line, such as `[robot] port "sim:robot" is on`. */
object Logs {
    fun to(out: PrintStream) {
        LogManager.getLogManager().reset()
        Logger.getLogger("").apply {
            level = Level.INFO
            addHandler(Flushed(out))
        }
    }

    private class Flushed(out: PrintStream) : StreamHandler(out, Line) {
        override fun publish(record: LogRecord) {
            super.publish(record)
            flush()
        }
    }

    private object Line : Formatter() {
        override fun format(record: LogRecord): String {
            val trace = record.thrown?.let { "\n" + it.stackTraceToString() }.orEmpty()
            return "[${record.loggerName?.substringAfterLast('.')}] ${formatMessage(record)}$trace\n"
        }
    }
}

/** A file that gets the log of Jason, ARGO and the agents, and all printed text, from its creation until [close]. */
internal class LogFile private constructor(val path: Path) : AutoCloseable {
    private val out = System.out
    private val err = System.err
    private val stream = PrintStream(Files.newOutputStream(path), true, Charsets.UTF_8)

    override fun close() {
        System.setOut(out)
        System.setErr(err)
        stream.close()
    }

    /** Closes and deletes the file. Call this after a successful run, whose log nobody needs. */
    fun delete() {
        close()
        Files.deleteIfExists(path)
    }

    companion object {
        fun open(name: String) = LogFile(Files.createTempFile("argo-$name-", ".log")).apply {
            System.setOut(stream)
            System.setErr(stream)
            Logs.to(stream)
        }
    }
}
