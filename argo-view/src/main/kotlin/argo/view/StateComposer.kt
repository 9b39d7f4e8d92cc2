package argo.view

import argo.filters.PerceptionFilter
import argo.filters.matching.warnings
import argo.observing.EndedReflex
import argo.observing.ObservedAgent
import argo.observing.ObservedComputer
import argo.observing.ObservedPort
import argo.observing.PerceivedMessage
import argo.observing.RuleWatcher
import argo.observing.WatchedRule
import java.util.concurrent.TimeUnit
import java.util.logging.Level
import java.util.logging.Logger
import argo.observing.PauseState as ObservedPause

/**
 * Composes the states of the page. For the view's thread only. Any thread may set [picture].
 *
 * @param tabs returns the tabs of agents, and the number of left-out agents
 */
internal class StateComposer(
    private val agent: ObservedAgent,
    private val record: AgentRecord,
    private val breakpoints: PageBreakpoints,
    private val tabs: () -> Pair<List<AgentTab>, Int>,
    private val log: Logger,
) {
    private val rows = PerceptRows()
    private val meter = RateMeter()
    private var shownVersion = -1L
    private var shownMind: MindWatch.Seen? = null
    private var shownTabs = emptyList<AgentTab>() to 0
    private var coursesNanos: Long? = null
    private var shownPicture: Picture? = null
    private var shownRules: List<WatchedRule> = emptyList()
    private var shownComputers: List<ObservedComputer> = emptyList()
    private var shownPause: ObservedPause? = null
    private var shownBreakpoints: List<BreakpointState> = emptyList()

    @Volatile
    var picture: () -> Picture? = { null }

    private var shownFilter: Pair<PerceptionFilter, FilterState>? = null

    /** Returns true if the page would differ from the last [state]. Asks for the project's picture, which may change at any time. */
    fun hasNews(): Boolean = record.version != shownVersion || record.mind.newest !== shownMind || currentPicture() != shownPicture ||
        agent.criticalRules() != shownRules || tabs() != shownTabs || agent.computers != shownComputers ||
        agent.pausing.state != shownPause || breakpoints.all != shownBreakpoints

    /** Takes in the last message of each board while no page is open, so that the courses of numbers have no gap. */
    fun takeIn() = takeIn(record.takeUnseen().associateBy { it.portName }.values, agent.ports())

    private fun takeIn(messages: Collection<PerceivedMessage>, ports: List<ObservedPort>) {
        val isAlone = ports.count { it.isPerceived } < 2
        messages.forEach { rows.add(it, isAlone) }
    }

    /** Returns the filter in words, with its parts that have no effect. Searches for these parts only once. */
    private fun filterState(filter: PerceptionFilter): FilterState {
        if (shownFilter?.first !== filter) {
            val words = (listOf("$filter") + filter.warnings()).joinToString(". Warning: ")
            shownFilter = filter to FilterState(filter.name, shown(words))
        }
        return checkNotNull(shownFilter).second
    }

    /**
     * Returns the state to show now. If [isLast] is true, the agent has ended. The state has courses of numbers once a second. If [isFull]
     * is true, it always has them.
     */
    fun state(isLast: Boolean, isFull: Boolean = true): ViewState {
        val now = agent.nanos()
        shownVersion = record.version
        shownMind = record.mind.newest
        shownTabs = tabs()
        shownPicture = currentPicture()
        shownRules = agent.criticalRules()
        shownComputers = agent.computers
        val pause = agent.pausing.state.also { shownPause = it }
        shownBreakpoints = breakpoints.all
        val recorded = record.take(now)
        val ports = agent.ports()
        val perceived = ports.count { it.isPerceived }
        takeIn(recorded.unseen, ports)
        return ViewState(
            agent = agent.name,
            policy = agent.policy,
            intervalMs = agent.intervalMs,
            skewMs = agent.skewMs.takeIf { perceived > 1 },
            perceiving = agent.isPerceiving,
            waitingToStart = recorded.counts.cycles == 0L,
            ended = isLast,
            filter = recorded.filter?.let(::filterState),
            critical = shownRules.take(MAX_RULES).map { criticalState(it, recorded.reflexes[it.rule], now) },
            moreCritical = maxOf(0, shownRules.size - MAX_RULES),
            ports = ports.map { portState(it, recorded.ports[it.name], now) },
            sensors = sensors(ports, recorded.lastPerception, now),
            beliefs = beliefs(shownMind, now),
            commands = recorded.commands,
            rates = meter.rates(now, recorded.counts),
            picture = shownPicture?.let { PictureState(it.svg, shown(it.words)) },
            intentions = IntentionsState(shownMind?.mind?.intended ?: 0, shownMind?.mind?.intentions.orEmpty()),
            printed = recorded.printed,
            courses = if (isFull || isCourseDue(now)) rows.courses(now).also { coursesNanos = now } else null,
            agents = shownTabs.first,
            moreAgents = shownTabs.second,
            computers = shownComputers.map(::computerState),
            pause = pauseState(pause),
            breakpoints = shownBreakpoints,
        )
    }

    private fun computerState(computer: ObservedComputer): ComputerState {
        val shown = computer.agents.take(MAX_AGENTS).map { AgentState(it.name, it.viewPort) }
        return computer.run { ComputerState(name, address, isHere, isNear, isOn, shown, agents.size - shown.size) }
    }

    private fun isCourseDue(now: Long) = coursesNanos.let { it == null || now - it >= COURSES_NANOS }

    private fun beliefs(seen: MindWatch.Seen?, now: Long) =
        BeliefsState(seen?.let { ms(now - it.nanos) }, seen?.mind?.believed ?: 0, seen?.mind?.beliefs.orEmpty())

    private fun currentPicture(): Picture? = try {
        picture()
    } catch (broken: Throwable) { // code of the project makes the picture, and may be unfinished: TODO() throws an error
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

    private fun pauseState(pause: ObservedPause) =
        PauseState(pause.phase.name.lowercase(), (listOfNotNull(pause.why) + pause.boards).joinToString("\n"), pause.intention)

    private fun sensors(ports: List<ObservedPort>, last: PerceptionTime?, now: Long): SensorState {
        val byName = ports.associateBy { it.name.removeSurrounding("\"") } // a name is a literal
        val (percepts, more) = rows.state(now, agent::perceptKinds) { name -> isSilent(byName[name] ?: ports.find { it.isInUse }) }
        return SensorState(
            frameAgeMs = rows.newestNanos?.let { ms(now - it) },
            handedOverAgeMs = last?.let { ms(now - it.nanos) },
            delayMs = last?.let { ms(it.delayNanos) },
            percepts = percepts,
            more = more,
            moreCourses = rows.moreCourses,
        )
    }

    private fun isSilent(port: ObservedPort?) = port != null && (port.isStale || port.status != "on")

    private companion object {
        const val MAX_RULES = 50
        const val MAX_AGENTS = 50
        val COURSES_NANOS: Long = TimeUnit.SECONDS.toNanos(1)
    }
}
