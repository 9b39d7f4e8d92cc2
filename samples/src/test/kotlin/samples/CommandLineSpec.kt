package samples

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import java.io.PrintWriter
import java.io.StringWriter

class CommandLineSpec : FunSpec({
    /** Returns the exit status and the output of the samples with [arguments]. Runs them in this process. */
    fun run(vararg arguments: String): Pair<Int, String> {
        val printed = StringWriter()
        val (commands, rest) = program(arrayOf(*arguments))
        val status = PrintWriter(printed, true).let { commands.setOut(it).setErr(it).execute(*rest) }
        return status to "$printed"
    }

    test("the program ends with the status of what it runs") {
        val (status, printed) = Program.run("collision", "--limit", "far")
        status shouldBe 2
        printed shouldStartWith "Invalid value for option '--limit': far is not a whole number"
        Program.run("blink", "--help").status shouldBe 0
    }

    context("wrong arguments are refused with a reason and exit status 2") {
        listOf(
            "collision --limit 500" to "--limit is from 1 to 199 cm, since the robot starts 200 cm from the wall, not 500",
            "collision --limit far" to "'--limit': far is not a whole number",
            "collision --filter front" to "--filter is none, frontSide or frontDistance, not front",
            "collision --sensing later" to "--sensing is fresh, every or in_cycle, not later",
            "collision --interval -1" to "--interval is from 0 to 10000 ms, not -1",
            "collision --baud 0" to "--baud is from 300 to 4000000 bits a second, not 0",
            "collision --boards 3" to "--boards is from 1 to 2",
            "collision --port sim:robot --boards 2" to "--boards is for the simulated robot",
            "collision --port sim:robot --watch" to "--watch is for the simulated robot",
            "collision --port sim:robot --seed 3" to "--seed is for the simulated robot",
            "collision --view=http" to "'--view': http is not a whole number",
            "collision --view=70000" to "--view is from 0 to 65535 as a port, 0 being any that is free, not 70000",
            "collision --view --view-wait=-1" to "--view-wait is from 0 to 3600 s, not -1",
            "collision --view-wait 5" to "--view-wait is for --view",
            "collision --fast" to "Unknown option: '--fast'",
            "collision --limt 30" to "Unknown option: '--limt'; did you mean --limit?",
            "blink --seconds 0" to "--seconds is at least 1, not 0",
            "collision --seed x" to "'--seed': x is not a whole number",
            "collision faster" to "'faster' is one argument too many",
            "race" to "there is no sample 'race'; there are: collision, blink",
            "demo --limit far" to "./argo demo --help lists the options",
            "" to "name a sample: collision, blink, delegation, two-boards",
        ).forEach { (line, reason) ->
            test("samples $line") {
                val (status, printed) = run(*line.split(' ').filter { it.isNotEmpty() }.toTypedArray())
                status shouldBe 2
                printed shouldContain reason
                printed shouldContain "--help lists the options"
            }
        }
    }

    context("help is shown for") {
        listOf("", "collision", "blink", "delegation", "two-boards", "three-boards", "sensing-agents").forEach { command ->
            test("samples $command".trim()) {
                val (status, printed) = run(*listOf(command, "--help").filter { it.isNotEmpty() }.toTypedArray())
                status shouldBe 0
                printed shouldStartWith "Usage: ./argo sample $command".trim()
            }
        }
        test("the demo") {
            val (status, printed) = run("demo", "--help")
            status shouldBe 0
            printed shouldStartWith "Usage: ./argo demo"
        }
    }
})
