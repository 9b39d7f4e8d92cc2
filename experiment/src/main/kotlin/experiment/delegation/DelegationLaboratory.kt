package experiment.delegation

import experiment.AgentHost
import experiment.GivenUp
import experiment.Punctuality
import javino.LineClock
import javino.sim.SimulatedBoard
import javino.sim.SimulatedBoards
import kotlinx.serialization.Serializable
import kotlin.random.Random

/**
 * The result of a run.
 *
 * @property reactions the times from a stimulus to its reaction in ms, in order, without those of the warm-up
 * @property missed the number of stimuli without a reaction within [Stimuli.LIMIT_MS]. Missed stimuli are not in [reactions]
 * @property busy the average number of processors used by the agents
 * @property lateMs the longest delay of this machine in the run, in ms
 */
@Serializable
internal data class DelegationResult(val reactions: List<Double>, val missed: Int, val busy: Double, val lateMs: Double) {
    /** All reaction times in ascending order. A missed stimulus counts with [Stimuli.LIMIT_MS]. */
    val times: List<Double> get() = reactions.sorted() + List(missed) { Stimuli.LIMIT_MS.toDouble() }

    val isLate: Boolean get() = lateMs > MAX_LATE_MS

    companion object {
        const val MAX_LATE_MS = 15.0
    }
}

/** Makes runs in real time, with agents on slow computers and boards on simulated lines. Safe for use by several threads. */
internal class DelegationLaboratory(
    private val host: AgentHost,
    private val punctuality: Punctuality,
    private val seed: Long,
    private val slowdown: Double,
    private val clock: LineClock = LineClock.system(),
) {
    fun run(run: DelegationRun, given: GivenUp): DelegationResult? {
        val begin = clock.nanos()
        val stimuli = Stimuli(run.load.sensors, clock, Random(31 * seed + run.id.hashCode()))
        val boards = run.design.boards.withIndex().associate { (i, kinds) -> "${run.id}_$i" to board(KindSketch(stimuli, kinds, i == 0)) }
        boards.forEach(SimulatedBoards::plugIn)
        val society = Society(run, boards.keys.toList(), slowdown, host)
        val agents = society.begin()
        try {
            if (given.await(WARM_UP_MS)) return null
            val start = clock.nanos()
            val busyBefore = society.busyNanos
            if (given.await(MEASURED_MS)) return null
            val end = clock.nanos()
            val busy = (society.busyNanos - busyBefore).toDouble() / (end - start)
            while (!stimuli.areOver(end)) if (given.await(LOOK_MS)) return null
            val times = stimuli.reactions.filter { it.at in start until end }.map { it.ms }
            return DelegationResult(times.filterNotNull(), times.count { it == null }, busy, punctuality.worstSinceMs(begin))
        } finally {
            agents.asReversed().forEach(host::end)
            boards.keys.forEach(SimulatedBoards::unplug)
        }
    }

    private fun board(sketch: KindSketch) = SimulatedBoard { sketch.run(it, clock, 0) }

    companion object {
        const val WARM_UP_MS = 700L
        const val MEASURED_MS = 2_500L

        const val EXPECTED_MS = WARM_UP_MS + MEASURED_MS + 500

        private const val LOOK_MS = 10L
    }
}
