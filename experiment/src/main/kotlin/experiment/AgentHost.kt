package experiment

import jason.architecture.AgArch
import jason.asSyntax.ASSyntax
import jason.asSyntax.ASSyntax.createLiteral
import jason.asSyntax.ASSyntax.createString
import jason.asSyntax.ASSyntax.parseTerm
import jason.asSyntax.Literal
import jason.infra.local.LocalAgArch
import jason.infra.local.LocalRuntimeServices
import jason.infra.local.RunLocalMAS
import samples.project.SampleProject
import jason.runtime.Settings as AgentSettings

/**
 * Runs Jason with as many agents `robot` of the project `experiment` as there are robots at the moment. A program can run only one Jason,
 * since Jason keeps itself in a static field. Safe for use by several threads.
 */
internal class AgentHost : RunLocalMAS() {
    private val source: String
    private val services = LocalRuntimeServices(this)

    init {
        ReflexFilters.offer()
        val sample = SampleProject("experiment")
        source = sample.mas.getAg("robot").source.toString()
        sample.mas.agents.clear()
        parseArgs(arrayOf("--no-net"))
        setProject(sample.mas)
        create()
        start()
    }

    /**
     * Creates and starts the agent of [trial]. The agent's robot is on [port], and [witnesses] stand in front of the agent's architectures.
     */
    fun begin(trial: Trial, port: String, witnesses: List<AgArch>): LocalAgArch {
        val settings = AgentSettings().apply { addOption("argo_sensing", trial.condition.sensing) }
        val given = services.createAgent(trial.id, source, null, listOf("argo.Arch"), null, settings, null)
        val agent = checkNotNull(getAg(given)) { "Jason could not create the agent ${trial.id}" }
        beliefs(trial, port).forEach { agent.ts.ag.addBel(it) }
        witnesses.forEach(agent::insertAgArch)
        services.startAgent(given)
        return agent
    }

    private fun beliefs(trial: Trial, port: String): List<Literal> {
        val protocol = trial.condition.protocol?.let { "protocol($it)" }
        val options = listOfNotNull("baud(${trial.baud})", "timeout(${answerLimitMs(trial)})", protocol)
        val filter = trial.view.filter(trial.condition, trial.limit)
        val others = listOf("value(${trial.limit})", "interval(${trial.interval})", "view($filter)")
        return others.map(ASSyntax::parseLiteral) + createLiteral("board", createString(port), parseTerm("$options"))
    }

    /** Ends [agent], which closes its port. Returns when its thread has ended, or after [END_LIMIT_MS] with a warning in the log. */
    fun end(agent: LocalAgArch) {
        agent.stopAg()
        agent.thread.join(END_LIMIT_MS)
        if (agent.thread.isAlive) LOG.log(System.Logger.Level.WARNING, "the agent ${agent.agName} still runs after $END_LIMIT_MS ms")
        delAg(agent.agName)
    }

    /** Ignores `.stopMAS` of one agent, since the others go on. */
    override fun finish(deadline: Int, stopJVM: Boolean, exitValue: Int) = Unit

    private companion object {
        const val END_LIMIT_MS = 2_000L
        val LOG: System.Logger = System.getLogger("experiment")
    }
}
