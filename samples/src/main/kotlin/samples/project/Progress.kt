package samples.project

import argo.tools.command.standardCharset
import java.io.Console
import java.io.PrintStream
import java.nio.charset.Charset
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Shows the progress of a run in one line. On a terminal, it rewrites the line. Elsewhere, it prints a new line from time to time. Safe for
 * use by several threads.
 *
 * @param inPlace true if [out] is a terminal
 */
class Progress(private val out: PrintStream, private val inPlace: Boolean, charset: Charset) {
    private val separator = if (charset.newEncoder().canEncode('·')) " · " else " - "
    private val lock = ReentrantLock()
    private var isOver = false
    private var width = 0
    private var nextPlain = 0L

    /**
     * Shows [facts] in one line. Does nothing after [end].
     *
     * @param nanos the time since the start of the run, which must not go back
     * @param drawing a drawing in front of the facts. The drawing is shown only on a terminal, and only if both fit into [MAX_COLUMNS]
     */
    fun show(facts: List<String>, nanos: Long, drawing: String? = null) = lock.withLock {
        if (!isOver) show(facts.joinToString(separator), nanos, drawing)
    }

    private fun show(facts: String, nanos: Long, drawing: String?) {
        if (inPlace) {
            val line = drawing?.let { "$it  $facts" }?.takeIf { it.length <= MAX_COLUMNS } ?: facts
            out.print("\r" + line.padEnd(width))
            out.flush()
            width = line.length
        } else if (nanos >= nextPlain) {
            out.println(facts)
            nextPlain = nanos + PLAIN_INTERVAL_NANOS
        }
    }

    /** Removes the line. Later output appears in its place. A second call has no effect. */
    fun end() = lock.withLock {
        if (width > 0) out.print("\r" + " ".repeat(width) + "\r")
        out.flush()
        width = 0
        isOver = true
    }

    companion object {
        private const val PLAIN_INTERVAL_NANOS = 5_000_000_000L

        /** The length of a line on a terminal of the usual width. A longer line would wrap and could not be rewritten. */
        const val MAX_COLUMNS = 79

        fun onStandardOutput() = Progress(System.out, isTerminal() && canRewrite(System.getenv()), standardCharset())

        /** Returns true if the terminal of a program with [environment] can rewrite a line. Logs of CI keep all printed text. */
        fun canRewrite(environment: Map<String, String>) = environment["TERM"] != "dumb" && environment["CI"].isNullOrEmpty()

        private fun isTerminal(): Boolean {
            val console = System.console() ?: return false
            // since Java 22, a console need not be a terminal
            val asked = Console::class.java.methods.find { it.name == "isTerminal" }
            return asked == null || asked.invoke(console) == true
        }
    }
}
