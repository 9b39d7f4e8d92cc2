package argo.exploring.command

import argo.exploring.Found
import argo.exploring.NotDeterministic
import argo.exploring.NothingFound
import argo.exploring.outcomeOf
import argo.exploring.reportOf
import argo.exploring.specOf
import java.io.IOException
import java.io.PrintStream
import java.nio.file.Path
import kotlin.io.path.writeText
import kotlin.system.exitProcess

/** The program of the tool `explore`; [explored] does its work. */
fun main(arguments: Array<String>): Unit = exitProcess(explored(arguments.toList(), System.out, System.err))

/**
 * Explores the agents in the file of the first argument. The other arguments are options of the tool `explore`, in the form `--NAME=VALUE`.
 *
 * @param err takes the reason if nothing is explored
 * @return the exit status: 0 no rule was broken, 2 wrong arguments, 3 no decision, 4 a rule was broken. A Java virtual machine that cannot
 * start never gives 4
 */
internal fun explored(arguments: List<String>, out: PrintStream, err: PrintStream): Int {
    val outcome = try {
        val options = ExploreArguments(arguments)
        outcomeOf(options.source) { describedBy(options) }.also { if (it is Found) options.spec?.let { file -> save(it, file, out) } }
    } catch (refused: IllegalArgumentException) {
        err.println(refused.message)
        return MISUSED
    } catch (failed: IOException) {
        err.println("the spec cannot be written: $failed")
        return FAILED
    }
    out.println(reportOf(outcome))
    return when (outcome) {
        is NothingFound -> DONE
        is Found -> FOUND
        is NotDeterministic -> FAILED
    }
}

private fun save(found: Found, file: Path, out: PrintStream) {
    file.writeText(specOf(found))
    out.println("the spec below is in $file\n")
}

private const val DONE = 0
private const val MISUSED = 2
private const val FAILED = 3
private const val FOUND = 4
