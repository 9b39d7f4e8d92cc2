package argo.tools.doctor

import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.doctor.Finding.Level
import argo.tools.command.printable
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import picocli.CommandLine.Command
import picocli.CommandLine.Option

/** `doctor`: what stands between this machine and a board. */
@Command(
    name = "doctor",
    description = [
        "Checks this machine for everything that a board needs, and reports remedies. Opens no port.",
        "Exit status 1 if there is a problem; warnings alone leave it 0.",
    ],
)
internal class DoctorCommand(private val machine: Machine) : ToolCommand() {
    @Suppress("unused") // by picocli
    constructor() : this(ThisMachine)

    @Option(names = ["--json"], description = ["prints an array of objects of JSON"])
    private var json = false

    override fun call(): Int {
        val findings = Examination(machine).findings()
        if (json) out.println(JsonArray(findings.map(::json))) else findings.forEach(::print)
        return if (findings.any { it.level == Level.PROBLEM }) ExitStatus.FAILED else ExitStatus.DONE
    }

    private fun print(finding: Finding) {
        val mark = when (finding.level) {
            Level.GOOD -> paint.good("ok      ")
            Level.WARNING -> paint.doubtful("warning ")
            Level.PROBLEM -> paint.bad("problem ")
        }
        out.println(mark + printable(finding.what))
        finding.remedy?.let { out.println("        " + printable(it)) }
    }

    private fun json(finding: Finding) = buildJsonObject {
        put("level", finding.level.name.lowercase())
        put("what", finding.what)
        put("remedy", finding.remedy)
    }
}
