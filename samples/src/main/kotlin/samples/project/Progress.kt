package samples.project

import java.io.Console
import java.io.PrintStream
import java.nio.charset.Charset
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The progress of a run in one line: rewritten in place on a terminal; elsewhere a plain line now and then.
 * Safe for use by several threads.
 *
 * @param inPlace whether [out] is a terminal
 * @param charset what [out] can print
 */
internal class Progress(private val out: PrintStream, private val inPlace: Boolean, charset: Charset) {
    private val separator = if (charset.newEncoder().canEncode('·')) " · " else " - "
    private val lock = ReentrantLock()
    private var isOver = false
    private var width = 0
    private var nextPlain = 0L

    /** Shows [facts] side by side, unless it has ended; [nanos] is the time since the run began, never less than before. */
    fun show(facts: List<String>, nanos: Long) = lock.withLock {
        if (!isOver) show(facts.joinToString(separator), nanos)
    }

    private fun show(line: String, nanos: Long) {
        if (inPlace) {
            out.print("\r" + line.padEnd(width))
            out.flush()
            width = line.length
        } else if (nanos >= nextPlain) {
            out.println(line)
            nextPlain = nanos + PLAIN_INTERVAL_NANOS
        }
    }

    /** Takes the line away for good, so that what follows stands in its place. May be called twice. */
    fun end() = lock.withLock {
        if (width > 0) out.print("\r" + " ".repeat(width) + "\r")
        out.flush()
        width = 0
        isOver = true
    }

    companion object {
        private const val PLAIN_INTERVAL_NANOS = 5_000_000_000L

        /** Progress on this program's standard output. */
        fun onStandardOutput() = Progress(System.out, isTerminal(), charset())

        private fun charset(): Charset =
            OUTPUT_ENCODINGS.firstNotNullOfOrNull(System::getProperty)?.let(Charset::forName) ?: Charset.defaultCharset()

        /** The properties for the terminal's character set in several versions of Java. */
        private val OUTPUT_ENCODINGS = listOf("stdout.encoding", "sun.stdout.encoding", "native.encoding")

        private fun isTerminal(): Boolean {
            val console = System.console() ?: return false
            // since Java 22 a console may have no terminal
            val asked = Console::class.java.methods.find { it.name == "isTerminal" }
            return asked == null || asked.invoke(console) == true
        }
    }
}
