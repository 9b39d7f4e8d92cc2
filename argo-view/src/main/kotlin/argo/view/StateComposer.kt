package argo.view

import argo.observing.ObservedAgent
import argo.observing.ObservedPort
import java.util.logging.Level
import java.util.logging.Logger

/**
 * Puts together what the page shows. [state] and [hasNews] belong to the view's thread, the rest is safe for use by several.
 *
 * @param nanos a clock in ns that never goes back
 */
internal class StateComposer(
    private val agent: ObservedAgent,
    private val record: AgentRecord,
    private val beliefs: BeliefWatch,
    private val log: Logger,
    private val nanos: () -> Long,
) {
    private val rows = PerceptRows()
    private val meter = RateMeter()
    private var shownVersion = -1L
    private var shownBeliefs: BeliefWatch.Picture? = null
    private var shownPicture: DistancePicture? = null

    /** What is asked for the picture. */
    @Volatile
    var picture: () -> DistancePicture? = { null }

    /** How it ended, in words. */
    @Volatile
    var conclusion: String? = null

    /** Whether something has happened since [state] was last asked; a picture may change at any time. */
    fun hasNews(): Boolean = record.version != shownVersion || beliefs.newest !== shownBeliefs || pictureNow() != shownPicture

    /** All there is to show now; [isLast] when the agent has ended. */
    fun state(isLast: Boolean): ViewState {
        shownVersion = record.version
        shownBeliefs = beliefs.newest
        shownPicture = pictureNow()
        record.frames.take().forEach(rows::add)
        val now = nanos()
        val counts = record.counts()
        return ViewState(
            agent = agent.name,
            policy = agent.policy,
            intervalMs = agent.intervalMs,
            perceiving = agent.isPerceiving,
            waitingToStart = counts.cycles == 0L,
            ended = if (isLast) conclusion ?: "the agent has ended" else null,
            filter = record.filter?.let { FilterState(it.name, shown("$it")) },
            ports = agent.ports().map { portState(it, now) },
            sensors = sensors(now),
            beliefs = BeliefsState(shownBeliefs?.let { ms(now - it.nanos) }, shownBeliefs?.total ?: 0, shownBeliefs?.beliefs.orEmpty()),
            commands = record.commands.state(now),
            rates = meter.rates(now, counts),
            picture = shownPicture?.run { PictureState(distance?.takeIf(Double::isFinite), limit?.takeIf(Double::isFinite), range, shown(unit), shown(doing)) },
        )
    }

    private fun pictureNow(): DistancePicture? = try {
        picture()
    } catch (broken: RuntimeException) { // a project's own code
        log.log(Level.WARNING, "the live view's picture is given up, since asking for it failed", broken)
        picture = { null }
        null
    }

    private fun portState(port: ObservedPort, now: Long): PortState {
        val change = record.changeOf(port.name)?.takeIf { it.status == port.status }
        return PortState(shown(port.name), port.status, port.isInUse, change?.reason, change?.let { ms(now - it.nanos) })
    }

    private fun sensors(now: Long): SensorState {
        val (percepts, more) = rows.state(now)
        val last = record.lastHandOver
        return SensorState(
            frameAgeMs = rows.newestNanos?.let { ms(now - it) },
            handedOverAgeMs = last?.let { ms(now - it.nanos) },
            delayMs = last?.let { ms(it.delayNanos) },
            percepts = percepts,
            more = more,
        )
    }
}
