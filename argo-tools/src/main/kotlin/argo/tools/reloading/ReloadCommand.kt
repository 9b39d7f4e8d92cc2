package argo.tools.reloading

import argo.filters.withControlsShown
import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.ToolException
import argo.tools.command.printableLines
import argo.tools.command.requireWithin
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters

@Command(
    name = "reload",
    description = [
        "Has a running agent read its program and filters anew, between two reasoning cycles.",
        "The agent has a live view, by argo_view=8080 in the .mas2j. A file with a mistake changes nothing.",
    ],
)
internal class ReloadCommand : ToolCommand() {
    @Parameters(index = "0", arity = "0..1", paramLabel = "AGENT", description = ["the agent (all agents with a live view at the port)"])
    private var agent: String? = null

    @Option(
        names = ["--view"], paramLabel = "PORT", defaultValue = "8080",
        description = ["the port of the live view, as in argo_view (\${DEFAULT-VALUE})"],
    )
    private var port = 0

    override fun call(): Int {
        spec.requireWithin("--view", port, 1..MAX_PORT)
        val views = RunningViews(port)
        val outcomes = wanted(views).map { it to views.reload(it) }
        for ((name, outcome) in outcomes) {
            (if (outcome.isDone) out else err).println("${withControlsShown(name)}: ${printableLines(outcome.words)}")
        }
        return if (outcomes.all { (_, outcome) -> outcome.isDone }) ExitStatus.DONE else ExitStatus.FAILED
    }

    private fun wanted(views: RunningViews): List<String> {
        val agents = views.agents()
        val wanted = agent ?: return agents
        if (wanted !in agents) throw ToolException("there is no agent $wanted at ${views.address}; there are: ${agents.joinToString()}")
        return listOf(wanted)
    }

    private companion object {
        const val MAX_PORT = 65_535
    }
}
