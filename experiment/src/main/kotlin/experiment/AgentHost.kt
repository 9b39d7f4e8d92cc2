package experiment

import jason.architecture.AgArch
import jason.asSyntax.ASSyntax
import jason.asSyntax.ASSyntax.createAtom
import jason.asSyntax.ASSyntax.createList
import jason.asSyntax.ASSyntax.createLiteral
import jason.asSyntax.ASSyntax.createNumber
import jason.asSyntax.ASSyntax.createString
import jason.asSyntax.Literal
import jason.infra.local.LocalAgArch
import jason.infra.local.LocalRuntimeServices
import jason.infra.local.RunLocalMAS
import samples.project.SampleProject
import jason.runtime.Settings as AgentSettings

/** The initial beliefs of an agent of the experiment: [port] with its options, the rest as in [Trial]. */
internal data class Orders(
    val port: String,
    val baud: Int,
    val timeoutMs: Int,
    val protocol: String?,
    val limit: Int,
    val interval: Int,
    val filter: String,
    val sensing: String,
) {
    /** The agent's initial beliefs. */
    fun beliefs(): List<Literal> {
        val options = listOfNotNull(
            createLiteral("baud", createNumber(baud.toDouble())),
            createLiteral("timeout", createNumber(timeoutMs.toDouble())),
            protocol?.let { createLiteral("protocol", ASSyntax.parseTerm(it)) },
        )
        return listOf(
            createLiteral("board", createString(port), createList(options)),
            createLiteral("value", createNumber(limit.toDouble())),
            createLiteral("interval", createNumber(interval.toDouble())),
            createLiteral("view", createAtom(filter)),
        )
    }
}

/** Returns the orders of an agent for [trial], whose robot is on [port]. */
internal fun orders(trial: Trial, port: String) = Orders(
    port = port,
    baud = trial.baud,
    timeoutMs = answerLimitMs(trial),
    protocol = trial.condition.protocol,
    limit = trial.limit,
    interval = trial.interval,
    filter = trial.view.filter(trial.condition, trial.limit),
    sensing = trial.condition.sensing,
)

/**
 * Jason, with as many agents `robot` of the project `experiment` as there are robots at the moment. A program has only one, since Jason
 * keeps the running one in a static. Safe for use by several threads.
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

    /** Creates an agent [name] with [orders], puts [witnesses] in front of its architectures, and starts it. */
    fun begin(name: String, orders: Orders, witnesses: List<AgArch>): LocalAgArch {
        val settings = AgentSettings().apply { addOption("argo_sensing", orders.sensing) }
        val given = services.createAgent(name, source, null, listOf("argo.Arch"), null, settings, null)
        val agent = checkNotNull(getAg(given)) { "Jason could not create the agent $name" }
        orders.beliefs().forEach { agent.ts.ag.addBel(it) }
        witnesses.forEach(agent::insertAgArch)
        services.startAgent(given)
        return agent
    }

    /** Ends [agent], which closes its port; returns when its thread has ended, or after [END_LIMIT_MS]. */
    fun end(agent: LocalAgArch) {
        agent.stopAg()
        agent.thread.join(END_LIMIT_MS)
        delAg(agent.agName)
    }

    /** Ignores `.stopMAS` of one agent: the others go on. */
    override fun finish(deadline: Int, stopJVM: Boolean, exitValue: Int) = Unit

    private companion object {
        const val END_LIMIT_MS = 2_000L
    }
}
