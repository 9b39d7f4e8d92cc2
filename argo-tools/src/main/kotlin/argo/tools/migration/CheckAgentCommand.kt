package argo.tools.migration

import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.printable
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.nio.file.Path

/** `check-agent`: reads programs for other versions of ARGO. */
@Command(
    name = "check-agent",
    description = [
        "Reads programs that were written for other versions of ARGO and says what would be otherwise here: file, line, what, and what to do.",
        "Exit status 1 if something must change; notes alone leave it 0.",
    ],
)
internal class CheckAgentCommand : ToolCommand() {
    @Parameters(arity = "1..*", paramLabel = "FILE", description = [".asl, .mas2j, .jcm, Gradle and XML filter files, or folders with them"])
    private lateinit var files: List<Path>

    @Option(names = ["--json"], description = ["prints an array of objects of JSON"])
    private var json = false

    override fun call(): Int {
        val migration = Migration(files)
        val advices = migration.advices()
        if (json) out.println(JsonArray(advices.map(::json))) else print(advices, migration.count)
        return if (advices.any { it.must }) ExitStatus.FAILED else ExitStatus.DONE
    }

    private fun print(advices: List<Advice>, files: Int) {
        for (advice in advices) {
            val mark = if (advice.must) paint.bad("must change: ") else paint.doubtful("note: ")
            out.println("${advice.file}:${advice.line}: $mark${printable(advice.what)}")
            out.println("    ${printable(advice.remedy)}")
        }
        val changes = advices.count { it.must }
        out.println("$files files read: $changes things must change, ${advices.size - changes} to know of")
    }

    private fun json(advice: Advice) = buildJsonObject {
        put("file", advice.file)
        put("line", advice.line)
        put("must", advice.must)
        put("what", advice.what)
        put("remedy", advice.remedy)
    }
}
