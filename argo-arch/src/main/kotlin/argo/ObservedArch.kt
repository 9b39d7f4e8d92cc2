package argo

import argo.filters.PerceptionFilter
import argo.observing.ObservedAgent
import argo.observing.ObservedPort
import argo.perception.BoardPercepts
import argo.perception.filterNames
import argo.perception.filterOf
import argo.platform.Platform
import argo.platform.Waker
import argo.ports.PortStates
import argo.sensing.StaleBeliefs
import jason.bb.BeliefBase
import java.util.concurrent.atomic.AtomicBoolean

/** [arch] as its observers see it. */
internal class ObservedArch(
    private val arch: Arch,
    private val states: PortStates,
    private val stale: StaleBeliefs,
    private val board: BoardPercepts,
    private val waker: Waker,
    private val platform: Platform,
) : ObservedAgent {
    override val name: String = arch.agName
    override val policy get() = arch.policy.word
    override val intervalMs get() = arch.intervalMs
    override val isPerceiving get() = arch.isPerceiving
    override val beliefs: BeliefBase get() = arch.ts.ag.bb

    override fun nanos() = platform.clock.nanos()

    override fun ports(): List<ObservedPort> {
        val inUse = arch.portInUse()?.terms.orEmpty()
        return states.all().map { (port, status) -> ObservedPort("$port", status.word, port in inUse, stale.isStale(port)) }
    }

    override fun filterNames() = filterNames(arch.ts.ag)
    override fun filter(name: String) = filterOf(arch.ts.ag, name)
    override fun explain(percept: String) = board.explain(percept)
    override fun perceiveThrough(filter: PerceptionFilter?, done: () -> Unit) = later(done) { arch.perceiveThrough(filter) }
    override fun perceive(open: Boolean, done: () -> Unit) = later(done) { arch.perceive(open) }
    override fun wake() = waker.wake { true }

    /** Has the agent's own thread do [work] before its next cycle. */
    private fun later(done: () -> Unit, work: () -> Unit) {
        val isDone = AtomicBoolean()
        arch.ts.runAtBeginOfNextCycle {
            work()
            isDone.set(true)
            done()
        }
        waker.wake(isDone::get)
    }
}
