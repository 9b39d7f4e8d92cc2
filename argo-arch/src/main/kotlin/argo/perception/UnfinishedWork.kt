package argo.perception

import argo.acting.CommandLedger
import argo.platform.Platform
import argo.platform.nowMs
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSyntax.Literal
import jason.bb.BeliefBase
import java.util.Collections
import java.util.IdentityHashMap
import java.util.concurrent.ConcurrentHashMap

/**
 * The queues of an agent in Jason. Any thread may read them.
 *
 * @property isStanding returns true if Jason takes no event from its queue now, for example during an atomic plan
 * @property running returns the intentions that wait for their next step
 * @property events returns the events that wait
 */
internal class ReasoningQueues(
    val isStanding: () -> Boolean = { false },
    val running: () -> Collection<Intention> = { emptyList() },
    val events: () -> Collection<Event> = { emptyList() },
) {
    /** Returns true if Jason takes events, and [FreshHandOver.MANY_EVENTS] wait. */
    fun areCrowded(): Boolean = !isStanding() && events().size >= FreshHandOver.MANY_EVENTS
}

/**
 * The work that a board's snapshot has caused in the agent, from its hand-over on. A new snapshot waits for this work, which would
 * otherwise pile up.
 * 1. The snapshot's percept events in Jason's queue. Jason handles one event in a cycle. Later events are not awaited, since a busy Jason
 *    environment could keep the agent from its sensors for good. While Jason takes no event, as during an atomic plan, the agent waits only
 *    [ATOMIC_PLAN_INTERVAL_MS]. This lets an atomic plan see the world.
 * 2. The commands to the board that were issued before the hand-over. The line is slower than the agent. Later commands are not awaited,
 *    since a plan that loops on `argo.act` would keep the agent from its sensors.
 * 3. The intentions that percept events of the board have begun. Jason runs one step in a cycle. An intention is awaited until it has
 *    finished, or waits, for example for the outcome of a command. After [LONG_MS] it is no longer awaited, since it is meant to run on.
 *
 * Any thread may call [isDone], [kindLeft], [waitingEvents] and [dueInMs]. All other functions are for the agent's thread only.
 *
 * @property commands the commands that the board holds
 * @param nowMs a clock in ms that never goes back
 * @param isOwn returns true if a percept belongs to the board, or is in the board's namespace and belongs to no perceived board. Called by
 * any thread
 */
internal class UnfinishedWork(
    val commands: CommandLedger,
    private val queues: ReasoningQueues = ReasoningQueues(),
    private val nowMs: () -> Long = Platform.system.nowMs,
    private val isOwn: (Literal) -> Boolean = { true },
) {
    /** The percept events in the queue just after the last snapshot's events were added. Null before, and while Jason takes no events. */
    @Volatile
    private var events: Set<Event>? = null

    /** The time of the last hand-over; null if there was none. */
    @Volatile
    private var handedOverMs: Long? = null

    @Volatile
    private var lastCommand = 0L
    private val deadlines = ConcurrentHashMap<Intention, Long>() // the time, in ms, until which each intention is awaited

    /** The number of events in Jason's queue, of any kind. */
    val waitingEvents: Int get() = queues.events().size

    /** Notes that a snapshot is being handed over. From now on, the work of this snapshot is awaited. */
    fun begin() {
        lastCommand = commands.lastIssued()
        events = null
        handedOverMs = nowMs()
    }

    /** Notes that the last snapshot's events have been added to the queue. Later events do not belong to this snapshot. */
    fun takenIn() {
        if (events != null || queues.isStanding()) return // once for each snapshot, since the queue may hold thousands of events
        events = queues.events().filterTo(Collections.newSetFromMap(IdentityHashMap())) { awaits(it) }
    }

    /**
     * Returns true if no work is left.
     *
     * @param isAwaited true if the agent's thread asks because a snapshot waits. If only intentions are left, the call then sets the time
     * until which they are awaited
     */
    fun isDone(isAwaited: Boolean = false): Boolean = kindLeft(isAwaited) == null

    private fun limit(begun: Collection<Intention>) {
        val now = nowMs()
        val deadline = now + maxOf(LONG_MS, now - (handedOverMs ?: now))
        deadlines.keys.retainAll(begun.toSet())
        begun.forEach { deadlines.putIfAbsent(it, deadline) }
    }

    /** Returns the kind of work that is left, in words; null if no work is left. */
    fun kindLeft(): String? = kindLeft(isAwaited = false)

    private fun kindLeft(isAwaited: Boolean): String? {
        if (!commands.allDoneUpTo(lastCommand)) return "commands issued before the last percepts have not left"
        if (!areEventsDone()) return "events of earlier percepts wait"
        val begun = begun()
        if (isAwaited) limit(begun)
        return if (begun.any(::awaits)) "plans that earlier percepts have begun still run" else null
    }

    /** Returns the ms until commands to other boards are no longer awaited; null if none is awaited. */
    fun dueInMs(): Long? = commands.dueInMs(lastCommand)

    private fun areEventsDone() =
        if (queues.isStanding()) handedOverMs.let { it == null || nowMs() - it >= ATOMIC_PLAN_INTERVAL_MS }
        else events?.isEmpty() == true || queues.events().none(::awaits)

    private fun awaits(event: Event): Boolean = events?.contains(event) ?: (isPerceptEvent(event) && isOwn(event.trigger.literal))

    private fun awaits(intention: Intention): Boolean = deadlines[intention]?.let { nowMs() < it } ?: true

    private fun begun(): List<Intention> = if (queues.isStanding()) emptyList() else queues.running().filter { intention ->
        beginningOf(intention)?.let { it.hasSource(BeliefBase.APercept) && isOwn(it) } == true
    }

    /** Returns the event that began [intention]. Returns null if the intention has finished, perhaps during this call. */
    private fun beginningOf(intention: Intention): Literal? = try {
        intention.bottom?.trigger?.literal
    } catch (_: NoSuchElementException) {
        null
    }

    companion object {
        /**
         * The shortest time, in ms, between two hand-overs while Jason takes no event, as during an atomic plan. The events of each
         * hand-over slow down each cycle, and must all be handled later.
         */
        const val ATOMIC_PLAN_INTERVAL_MS = 100

        /**
         * The least time, in ms, for which an intention is awaited. If the other work of its snapshot took longer, an intention is awaited
         * for that longer time.
         */
        const val LONG_MS = 1000L
    }
}

/** Returns true if [event] means that a percept came or went. */
internal fun isPerceptEvent(event: Event): Boolean =
    event.isExternal && event.trigger.isUpdate && event.trigger.literal.hasSource(BeliefBase.APercept)
