package argo.tools.filter

import argo.filters.matching.Explanation
import argo.filters.matching.Explanation.Outcome
import argo.filters.matching.matcher
import argo.filters.matching.perceptsOf
import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.printable
import java.nio.file.Path
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters

/** `filter explain`: what a filter does with percepts. */
@Command(name = "explain", description = ["Says of each percept what the filter does with it, and which of its rules decides. Rates are not tried, since they need time."])
internal class FilterExplainCommand : ToolCommand() {
    @Parameters(index = "0", paramLabel = "FILE", description = ["XML or JSON"])
    private lateinit var file: Path

    @Parameters(index = "1..*", arity = "1..*", paramLabel = "PERCEPT", description = ["as the board sends it: \"dist(f,30)\", or a whole message: \"dist(f,30);light(b,7);\""])
    private lateinit var messages: List<String>

    @Option(names = ["--json"], description = ["prints an array of objects of JSON"])
    private var json = false

    override fun call(): Int {
        val matcher = filterIn(file).matcher()
        val explanations = messages.flatMap(::perceptsOf).map(matcher::explain)
        if (json) out.println(JsonArray(explanations.map(::json))) else explanations.forEach { out.println(painted(it)) }
        return ExitStatus.DONE
    }

    private fun painted(explanation: Explanation) = printable("$explanation").let { if (explanation.outcome == Outcome.DROPPED) paint.doubtful(it) else it }

    private fun json(explanation: Explanation): JsonObject = buildJsonObject {
        put("percept", explanation.percept)
        put("outcome", explanation.outcome.name.lowercase())
        put("rule", explanation.rule?.toString())
        put("why", "$explanation")
    }
}
