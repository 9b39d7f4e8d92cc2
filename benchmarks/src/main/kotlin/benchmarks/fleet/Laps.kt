@file:Suppress("ClassName") // Jason finds internal actions by these names

package benchmarks.fleet

import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.ListTerm
import jason.asSyntax.NumberTerm
import jason.asSyntax.Term
import java.io.File

/** The file in which [counted] writes the process, the time in ns and the count. */
internal const val COUNTS = "counts.txt"

/** The file in which [known] writes the process and a digest of the names. */
internal const val NAMES = "names.txt"

/** The round-trip times of an agent's messages. */
internal object Laps {
    /** The number of first messages that do not count. Java has not compiled the code by then. */
    private const val COLD = 3000
    private const val MEASURED = 10_000

    const val FILE = "laps.txt"
    private val nanos = mutableListOf<Long>()
    private var begin = 0L

    fun begin() {
        begin = System.nanoTime()
    }

    fun end() {
        nanos += System.nanoTime() - begin
        if (nanos.size < COLD + MEASURED) return
        File(FILE).writeText(nanos.drop(COLD).joinToString("\n"))
        Runtime.getRuntime().halt(0)
    }
}

private fun note(file: String, vararg numbers: Long) = File(file).appendText(numbers.joinToString(" ", postfix = "\n"))

private fun pid() = ProcessHandle.current().pid()

/** The internal action `benchmarks.fleet.left` starts the time of a message. */
class left : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        Laps.begin()
        return true
    }
}

/** The internal action `benchmarks.fleet.came` ends the time of a message. The last answer ends the program. */
class came : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        Laps.end()
        return true
    }
}

/** The internal action `benchmarks.fleet.counted(N)` writes the count N. */
class counted : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        note(COUNTS, pid(), System.nanoTime(), (args[0] as NumberTerm).solve().toLong())
        return true
    }
}

/** The internal action `benchmarks.fleet.known(Names)` writes a digest of the names of all agents. */
class known : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        note(NAMES, pid(), (args[0] as ListTerm).map { "$it" }.sorted().hashCode().toLong())
        return true
    }
}
