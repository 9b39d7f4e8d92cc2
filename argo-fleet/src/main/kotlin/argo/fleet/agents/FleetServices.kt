package argo.fleet.agents

import argo.fleet.node.Fleet
import argo.fleet.node.Kill
import argo.fleet.node.Place
import argo.fleet.node.Stop
import argo.fleet.node.unreachable
import jason.JasonException
import jason.asSemantics.Agent
import jason.infra.local.BaseLocalMAS
import jason.infra.local.LocalAgArch
import jason.infra.local.LocalRuntimeServices
import jason.mas2j.ClassParameters
import jason.runtime.Settings
import jason.runtime.SourcePath
import java.util.logging.Logger

/**
 * The services of Jason's runtime in a fleet. Names, registered services and the end of the system concern all computers. New agents run on
 * this computer.
 *
 * Jason 3.2.1 has `getAgentsNames`, which Jason 3.3.0 calls `getAgentsName`.
 */
internal class FleetServices(
    private val mas: BaseLocalMAS,
    private val fleet: Fleet,
    private val facilitator: DirectoryFacilitator,
    private val log: Logger,
) : LocalRuntimeServices(mas) {
    private class Making(val name: String, val architecture: () -> LocalAgArch)

    /** The project's agent that the calling thread is creating, or null. */
    private val making = ThreadLocal<Making>()

    /** Lets [create] create an agent of the project under the name [name]. [architecture] makes the agent's infrastructure. */
    fun createOwn(name: String, architecture: () -> LocalAgArch, create: FleetServices.() -> Unit) {
        making.set(Making(name, architecture))
        try {
            create()
        } finally {
            making.remove()
        }
    }

    /**
     * Returns true also while this thread creates agents. Jason creates agents only in a running system, and the project's agents must
     * exist earlier.
     */
    override fun isRunning() = making.get() != null || super.isRunning()

    override fun newAgInstance(): LocalAgArch = making.get()?.architecture?.invoke() ?: FleetAgArch(fleet)

    override fun getNewAgentName(base: String): String =
        if (base == making.get()?.name) base
        else (sequenceOf(base) + generateSequence(1) { it + 1 }.map { "${base}_$it" }).first { fleet.directory.find(it) == Place.Unknown }

    /** Leaves out the infrastructure of [father]. Jason lists it among the architectures for the new agent. */
    override fun createAgent(
        name: String?, source: String?, agentClass: String?, architectures: List<String>?, beliefBase: ClassParameters?,
        settings: Settings?, father: Agent?,
    ): String {
        val given = architectures.orEmpty().ifEmpty { father?.run { others(ts.agArch.agArchClassesChain) }.orEmpty() }
        if (father?.aslSrc?.startsWith(SourcePath.CRPrefix) == true) mas.project.sourcePaths.addPath(SourcePath.CRPrefix)
        return super.createAgent(name, source, agentClass, given, beliefBase, settings, null)
    }

    override fun clone(source: Agent, architectures: List<String>, name: String) = super.clone(source, others(architectures), name)

    private fun others(architectures: List<String>) = architectures - FleetAgArch::class.java.name

    override fun getAgentsNames(): Collection<String> = fleet.directory.names

    /** Jason 3.3.0 calls this in place of [getAgentsNames]. */
    @Suppress("unused")
    fun getAgentsName(): Collection<String> = agentsNames

    override fun getAgentsQty(): Int = fleet.directory.names.size

    /** @throws JasonException with an `error(…)` for plans if no computer in touch has [agent] */
    override fun killAgent(agent: String, by: String, deadlineMs: Int): Boolean {
        val directory = fleet.directory
        when (val place = directory.find(agent)) {
            Place.Here -> return super.killAgent(agent, by, deadlineMs)
            is Place.There -> Deliveries.add(Delivery(null, agent, log, fleet.send(place.computer, Kill(agent, by, deadlineMs))))
            is Place.Off -> throw errorOf(unreachable(agent, place, directory))
            Place.Unknown -> throw noAgent("there is no agent $agent in the fleet for $by to kill")
        }
        return true
    }

    /** Stops the agents and the programs on all computers. */
    override fun stopMAS(deadlineMs: Int, stopsJvm: Boolean, exitStatus: Int) {
        fleet.stopOthers(Stop(deadlineMs, stopsJvm, exitStatus)).whenComplete { _, _ -> mas.finish(deadlineMs, stopsJvm, exitStatus) }
    }

    override fun dfRegister(agent: String, service: String, type: String?) = facilitator.register(agent, service)

    override fun dfDeRegister(agent: String, service: String, type: String?) = facilitator.deregister(agent, service)

    override fun dfSearch(service: String, type: String?): Collection<String> = facilitator.search(service)

    override fun dfSubscribe(agent: String, service: String, type: String?) = facilitator.subscribe(agent, service)

    override fun getDF(): Map<String, Set<String>> = facilitator.services()
}
