package argo.tools.filter

import argo.filters.matching.Explanation
import argo.filters.matching.Explanation.Outcome
import argo.filters.matching.matcher
import argo.filters.matching.perceptsOf
import argo.filters.withControlsShown
import argo.tools.command.DataCommand
import argo.tools.command.ExitStatus
import argo.tools.command.jsonArrayOf
import argo.tools.command.jsonOf
import picocli.CommandLine.Command
import picocli.CommandLine.Parameters
import java.nio.file.Path

@Command(
    name = "explain",
    description = [
        "Explains for each percept whether the filter drops it, and by which rule, as if it were the first of its sensor: " +
            "rates, smoothing and second limits depend on those before.",
    ],
)
internal class FilterExplainCommand : DataCommand() {
    @Parameters(index = "0", paramLabel = "FILE", description = ["XML or JSON"])
    private lateinit var file: Path

    @Parameters(
        index = "1..*", arity = "1..*", paramLabel = "PERCEPT",
        description = ["as sent by the board: \"dist(f,30)\", or a whole message: \"dist(f,30);light(b,7);\""],
    )
    private lateinit var messages: List<String>

    override fun call(): Int {
        val percepts = messages.flatMap(::perceptsOf)
        if (percepts.isEmpty()) misuse("there is no percept in ${messages.joinToString { "'$it'" }}; expected one such as \"dist(f,30)\"")
        val explanations = percepts.map(filterIn(file).matcher()::explain)
        if (json) out.println(jsonArrayOf(explanations.map(::json))) else explanations.forEach { out.println(painted(it)) }
        return ExitStatus.DONE
    }

    private fun painted(explanation: Explanation): String {
        val text = withControlsShown("$explanation")
        return if (explanation.outcome == Outcome.DROPPED) paint.doubtful(text) else text
    }

    private fun json(explanation: Explanation) = jsonOf(
        "percept" to explanation.percept, "outcome" to explanation.outcome.name.lowercase(),
        "rule" to explanation.rule, "why" to explanation,
    )
}
