package samples.project

import argo.Arch
import argo.view.AgentView
import jason.architecture.AgArch
import jason.asSyntax.directives.DirectiveProcessor
import jason.asSyntax.directives.Include
import jason.infra.local.RunLocalMAS
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * Runs a Jason project inside this program: without a window, without a network service, and without ending the program when an agent ends
 * the system with `.stopMAS`. Only one runs at a time, since Jason keeps it in a static.
 */
internal class MasRun(private val sample: SampleProject) : RunLocalMAS() {
    private val ended = CompletableFuture<Int>()

    init {
        parseArgs(arrayOf("--no-net"))
        setProject(sample.mas)
        (DirectiveProcessor.getDirective("include") as Include).setSourcePath(sample.mas.sourcePaths) // as Jason does, for all agents
    }

    /**
     * Creates the agents and starts them; puts each of [witnesses] in front of the architectures of the agent with its name.
     *
     * @param beforeStart is called when the agents are there and do not run yet
     * @throws IllegalStateException if an agent cannot be created; the log has Jason's reasons
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

    /** Returns the live view of [agent], once it is created; null: it has none. */
    fun viewOf(agent: String): AgentView? =
        generateSequence(ags.getValue(agent).firstAgArch) { it.nextAgArch }.filterIsInstance<Arch>().flatMap { it.observers }
            .filterIsInstance<AgentView>().firstOrNull()

    /** Waits until an agent has ended the system, at most [millis] ms; returns the agent's exit status, null if none has. */
    fun awaitEnd(millis: Long): Int? = try {
        ended.get(millis, TimeUnit.MILLISECONDS)
    } catch (_: TimeoutException) {
        null
    }

    /** Stops all agents, which close their ports. */
    fun end() = stopAgs(0)

    /** Notes the end of the system by `.stopMAS`. */
    override fun finish(deadline: Int, stopJVM: Boolean, exitValue: Int) {
        ended.complete(exitValue)
    }
}
