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
 * Runs one Jason. Agents are started and ended while it runs. A program can run only one Jason, since Jason stores it in a static field.
 * Safe for use by several threads.
 */
internal class AgentHost : RunLocalMAS() {
    private val services = LocalRuntimeServices(this)

    init {
        ReflexFilters.offer()
        val project = SampleProject("experiment").mas
        project.agents.clear()
        parseArgs(arrayOf("--no-net"))
        setProject(project)
        create()
        start()
    }

    fun begin(trial: Trial, port: String, witnesses: List<AgArch>): LocalAgArch = begin(
        trial.id, "robot.asl", options = mapOf("argo_sensing" to trial.condition.sensing), beliefs = beliefs(trial, port),
        witnesses = witnesses,
    )

    /**
     * Creates and starts an agent.
     *
     * @param program the file of the program in the folder `agent`
     * @param isArgo true for an ARGO agent with these [options], as in a `.mas2j`; false for a common Jason agent
     * @param beliefs initial beliefs beside those of the program
     * @param plans plans behind those of the program
     * @param witnesses architectures in front of its own
     */
    fun begin(
        name: String, program: String, isArgo: Boolean = true, options: Map<String, String> = emptyMap(), beliefs: List<Literal>,
        plans: List<String> = emptyList(), witnesses: List<AgArch>,
    ): LocalAgArch {
        val source = checkNotNull(javaClass.getResource("/experiment/$program")) { "there is no $program" }
        val settings = AgentSettings().apply { options.forEach(::addOption) }
        val archs = if (isArgo) listOf("argo.Arch") else emptyList()
        val given = services.createAgent(name, "$source", null, archs, null, settings, null)
        val agent = checkNotNull(getAg(given)) { "Jason could not create the agent $name" }
        beliefs.forEach(agent.ts.ag::addBel)
        plans.forEach { agent.ts.ag.pl.add(ASSyntax.parsePlan(it)) }
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

    /** Ends [agent], which closes its port. Waits for the end of its thread. After [END_LIMIT_MS], logs a warning and returns. */
    fun end(agent: LocalAgArch) {
        agent.stopAg()
        agent.thread.join(END_LIMIT_MS)
        if (agent.thread.isAlive) LOG.log(System.Logger.Level.WARNING, "the agent ${agent.agName} still runs after $END_LIMIT_MS ms")
        delAg(agent.agName)
    }

    /** Ignores `.stopMAS`, which would end all agents. */
    override fun finish(deadline: Int, stopJVM: Boolean, exitValue: Int) = Unit

    private companion object {
        const val END_LIMIT_MS = 2_000L
        val LOG: System.Logger = System.getLogger("experiment")
    }
}
