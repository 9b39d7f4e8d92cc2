package samples.project

import java.io.Console
import java.io.PrintStream
import java.nio.charset.Charset
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * One line that says how a run gets on: written anew in its place on a terminal; elsewhere a plain line now and then.
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

        private fun charset(): Charset = OUTPUT_ENCODINGS.firstNotNullOfOrNull(System::getProperty)?.let(Charset::forName) ?: Charset.defaultCharset()

        private val OUTPUT_ENCODINGS = listOf("stdout.encoding", "sun.stdout.encoding", "native.encoding") // which of them there are depends on the Java version

        private fun isTerminal(): Boolean {
            val console = System.console() ?: return false
            val asked = Console::class.java.methods.find { it.name == "isTerminal" } // from Java 22 on there is a console without a terminal, too
            return asked == null || asked.invoke(console) == true
        }
    }
}
