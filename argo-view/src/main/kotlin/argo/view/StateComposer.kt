package argo.view

import argo.observing.EndedReflex
import argo.observing.ObservedAgent
import argo.observing.ObservedPort
import argo.observing.RuleWatcher
import argo.observing.WatchedRule
import java.util.logging.Level
import java.util.logging.Logger

/** Composes what the page shows. Belongs to the view's thread, but for [picture]. */
internal class StateComposer(private val agent: ObservedAgent, private val record: AgentRecord, private val log: Logger) {
    private val rows = PerceptRows()
    private val meter = RateMeter()
    private var shownVersion = -1L
    private var shownBeliefs: BeliefWatch.Picture? = null
    private var shownPicture: Picture? = null
    private var shownRules: List<WatchedRule> = emptyList()

    /** Gives the project's picture. */
    @Volatile
    var picture: () -> Picture? = { null }

    /** Whether something has happened since the last [state]; the project's picture may change at any time. */
    fun hasNews(): Boolean = record.version != shownVersion || record.beliefs.newest !== shownBeliefs || currentPicture() != shownPicture ||
        agent.criticalRules() != shownRules

    /** All there is to show now; [isLast] when the agent has ended. */
    fun state(isLast: Boolean): ViewState {
        val now = agent.nanos()
        shownVersion = record.version
        shownBeliefs = record.beliefs.newest
        shownPicture = currentPicture()
        shownRules = agent.criticalRules()
        val recorded = record.take(now)
        val ports = agent.ports()
        val perceived = ports.count { it.isPerceived }
        recorded.unseen.forEach { rows.add(it, isAlone = perceived < 2) }
        return ViewState(
            agent = agent.name,
            policy = agent.policy,
            intervalMs = agent.intervalMs,
            skewMs = agent.skewMs.takeIf { perceived > 1 },
            perceiving = agent.isPerceiving,
            waitingToStart = recorded.counts.cycles == 0L,
            ended = isLast,
            filter = recorded.filter?.let { FilterState(it.name, shown("$it")) },
            critical = shownRules.take(MAX_RULES).map { criticalState(it, recorded.reflexes[it.rule], now) },
            ports = ports.map { portState(it, recorded.ports[it.name], now) },
            sensors = sensors(ports, recorded.lastPerception, now),
            beliefs = BeliefsState(shownBeliefs?.let { ms(now - it.nanos) }, shownBeliefs?.total ?: 0, shownBeliefs?.beliefs.orEmpty()),
            commands = recorded.commands,
            rates = meter.rates(now, recorded.counts),
            picture = shownPicture?.let { PictureState(it.svg, shown(it.words)) },
        )
    }

    private fun currentPicture(): Picture? = try {
        picture()
    } catch (broken: Exception) { // a project's own code
        log.log(Level.WARNING, "the live view shows no picture any more, since asking for it failed", broken)
        picture = { null }
        null
    }

    private fun criticalState(watched: WatchedRule, reflex: EndedReflex?, now: Long) = CriticalState(
        rule = shown("${watched.rule}"),
        watcher = watched.watcher.key,
        reflex = reflex?.let { if (it.failure == null) "done" else "failed" },
        by = reflex?.watcher?.key,
        ageMs = reflex?.let { ms(now - it.nanos) },
        error = reflex?.failure?.let { shown("${it.error}: ${it.cause}") },
    )

    private val RuleWatcher.key get() = name.lowercase()

    private fun portState(port: ObservedPort, last: PortChange?, now: Long): PortState {
        val change = last?.takeIf { it.status == port.status }
        return PortState(
            shown(port.name), port.status, port.isInUse, port.isStale, port.isPerceived, port.namespace, port.intervalMs, port.filter,
            change?.reason, change?.let { ms(now - it.nanos) },
        )
    }

    private fun sensors(ports: List<ObservedPort>, last: Perception?, now: Long): SensorState {
        val (percepts, more) = rows.state(now) { name -> isSilent(ports.find { it.name == name } ?: ports.find { it.isInUse }) }
        return SensorState(
            frameAgeMs = rows.newestNanos?.let { ms(now - it) },
            handedOverAgeMs = last?.let { ms(now - it.nanos) },
            delayMs = last?.let { ms(it.delayNanos) },
            percepts = percepts,
            more = more,
        )
    }

    private fun isSilent(port: ObservedPort?) = port != null && (port.isStale || port.status != "on")

    private companion object {
        const val MAX_RULES = 50
    }
}
