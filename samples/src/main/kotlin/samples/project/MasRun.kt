package samples.project

import argo.Arch
import argo.observing.ObservedAgent
import argo.view.AgentView
import jason.architecture.AgArch
import jason.asSyntax.directives.DirectiveProcessor
import jason.asSyntax.directives.Include
import jason.infra.local.RunLocalMAS
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * Runs a Jason project in this program, without a window or a network service. The program continues after an agent has ended the project
 * by `.stopMAS`. Only one project can run at a time, since Jason stores it in a static field.
 */
internal class MasRun(private val sample: SampleProject) : RunLocalMAS() {
    private val ended = CompletableFuture<Int>()

    init {
        parseArgs(arrayOf("--no-net"))
        setProject(sample.mas)
        (DirectiveProcessor.getDirective("include") as Include).setSourcePath(sample.mas.sourcePaths) // for the includes of all agents
    }

    /**
     * Creates and starts the agents. Puts each of [witnesses] in front of the architectures of the agent named by its key.
     *
     * @param beforeStart called after the agents are created and before they run
     * @throws IllegalStateException if an agent cannot be created. The log has Jason's reasons
     */
    fun begin(witnesses: Map<String, AgArch> = emptyMap(), beforeStart: () -> Unit = {}) {
        create()
        val missing = project.agents.map { it.name } - ags.keys
        check(missing.isEmpty()) { "Jason could not create ${missing.joinToString()}" }
        sample.beliefs.forEach { (agent, beliefs) -> beliefs.forEach { ags.getValue(agent).ts.ag.addBel(it) } }
        witnesses.forEach { (agent, witness) -> ags.getValue(agent).insertAgArch(witness) }
        beforeStart()
        start()
    }

    /**
     * Runs the project until its agents end it. Prints its log on the standard output. Returns the exit status of the agents. If the agents
     * have not ended the project within [MAX_S] s, reports that as an error and returns 1.
     */
    fun toItsEnd(): Int = logged(MAX_S) ?: 1.also { System.err.println("the agents have not ended within $MAX_S s") }

    /** Works like [toItsEnd], but ends the project after [seconds] s with exit status 0. */
    fun forAtMost(seconds: Int): Int = logged(seconds) ?: 0

    private fun logged(seconds: Int): Int? {
        Logs.to(System.out)
        begin()
        try {
            return awaitEnd(seconds * 1000L)
        } finally {
            end()
        }
    }

    /** Returns the live view of [agent], or null if it has none. Call this function after the agent's creation. */
    fun viewOf(agent: String): AgentView? = archOf(agent).observers.filterIsInstance<AgentView>().firstOrNull()

    /** Returns [agent] for observers. Call this function after the agent's creation with ARGO's architecture. */
    fun observed(agent: String): ObservedAgent = archOf(agent).observed

    private fun archOf(agent: String): Arch =
        generateSequence(ags.getValue(agent).firstAgArch) { it.nextAgArch }.filterIsInstance<Arch>().first()

    /**
     * Waits for up to [millis] ms until an agent has ended the project. Returns the agent's exit status, or null if no agent has ended it.
     */
    fun awaitEnd(millis: Long): Int? = try {
        ended.get(millis, TimeUnit.MILLISECONDS)
    } catch (_: TimeoutException) {
        null
    }

    fun end() = stopAgs(0)

    /** Stores that an agent has ended the project by `.stopMAS`. */
    override fun finish(deadline: Int, stopJVM: Boolean, exitValue: Int) {
        ended.complete(exitValue)
    }

    private companion object {
        const val MAX_S = 60
    }
}
