package argo.tools.migration

import argo.tools.command.DataCommand
import argo.tools.command.ExitStatus
import argo.tools.command.counted
import argo.tools.command.jsonArrayOf
import argo.tools.command.jsonOf
import argo.tools.command.printable
import picocli.CommandLine.Command
import picocli.CommandLine.Parameters
import java.nio.file.Path

@Command(
    name = "check-agent",
    description = [
        "Reports what behaves differently when a program for another ARGO version runs on this one, with file, line and remedy.",
        "Exit status 1 if something must change; notes leave it 0.",
    ],
)
internal class CheckAgentCommand : DataCommand() {
    @Parameters(arity = "1..*", paramLabel = "FILE", description = [".asl, .mas2j, .jcm, Gradle and XML filter files, or their folders"])
    private lateinit var files: List<Path>

    override fun call(): Int {
        val migration = Migration(files)
        val advices = migration.advices()
        if (json) out.println(jsonArrayOf(advices.map(::json))) else print(advices, migration.count)
        return if (advices.any { it.must }) ExitStatus.FAILED else ExitStatus.DONE
    }

    private fun print(advices: List<Advice>, files: Int) {
        for (advice in advices) {
            val mark = if (advice.must) paint.bad("must change: ") else paint.doubtful("note: ")
            out.println("${advice.place}: $mark${printable(advice.what)}")
            out.println("    ${printable(advice.remedy)}")
        }
        val changes = advices.count { it.must }
        val change = "${counted(changes, "thing")} must change"
        out.println("${counted(files, "file")} read: $change, ${counted(advices.size - changes, "note")}")
    }

    private fun json(advice: Advice) =
        jsonOf(
            "file" to advice.file, "line" to advice.line, "column" to advice.column, "must" to advice.must, "what" to advice.what,
            "remedy" to advice.remedy,
        )
}
