package argo.tools.doctor

import argo.filters.withControlsShown
import argo.tools.board.Probe
import argo.tools.board.ProbedBoard
import argo.tools.command.DataCommand
import argo.tools.command.ExitStatus
import argo.tools.command.jsonArrayOf
import argo.tools.command.jsonOf
import argo.tools.doctor.Finding.Level
import picocli.CommandLine.Command
import picocli.CommandLine.Option

@Command(
    name = "doctor",
    description = [
        "Checks this machine for everything that a board needs, and reports remedies. Opens no port, unless --probe is given.",
        "Exit status 1 if there is a problem; warnings leave it 0.",
    ],
)
internal class DoctorCommand(
    private val machine: Machine,
    private val probe: (String) -> ProbedBoard = Probe(Probe.USUAL)::of,
) : DataCommand() {
    @Option(names = ["--probe"], description = ["requests percepts at each free USB port. Opening it resets most boards; motors may jerk"])
    private var probes = false

    @Suppress("unused") // picocli sets this field
    constructor() : this(ThisMachine)

    override fun call(): Int {
        val findings = Examination(machine).findings(if (probes) probe else null)
        if (json) out.println(jsonArrayOf(findings.map(::json))) else findings.forEach(::print)
        return if (findings.any { it.level == Level.PROBLEM }) ExitStatus.FAILED else ExitStatus.DONE
    }

    private fun print(finding: Finding) {
        val mark = when (finding.level) {
            Level.GOOD -> paint.good("ok      ")
            Level.WARNING -> paint.doubtful("warning ")
            Level.PROBLEM -> paint.bad("problem ")
        }
        out.println(mark + withControlsShown(finding.what))
        finding.remedy?.let { out.println("        " + withControlsShown(it)) }
    }

    private fun json(finding: Finding) =
        jsonOf("level" to finding.level.name.lowercase(), "what" to finding.what, "remedy" to finding.remedy)
}
