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
 * The queues of an agent in Jason, which any thread may go through.
 *
 * @property isStanding returns true if Jason takes no event from its queue now, as while an atomic plan runs or waits
 * @property running returns the intentions that wait for their next step
 * @property events returns the events that wait
 */
internal class ReasoningQueues(
    val isStanding: () -> Boolean = { false },
    val running: () -> Collection<Intention> = { emptyList() },
    val events: () -> Collection<Event> = { emptyList() },
)

/**
 * The work that the last snapshot of a board has left to the agent: 1. the snapshot's percept events in Jason's queue, but no later events:
 *    those of a busy Jason environment could keep the agent from its sensors for good. While the queue stands, the agent awaits no event,
 *    only [ATOMIC_PLAN_INTERVAL_MS]. So an atomic plan sees the world too. But each snapshot during an atomic plan adds events. Jason goes
 *    through all of them in each cycle, and the agent must work them off later;
 * 2. the commands that the board holds and that were issued before the snapshot was handed over;
 * 3. the intentions that percept events of the board have begun. Such an intention is done when it has finished, or waits, as for the
 *    outcome of a command. An intention that still runs after [LONG_MS] is no longer awaited, since it is meant to run on. Jason handles
 *    one event a cycle, so without (1) events pile up. The line is slower than the agent, so without (2) commands pile up. Jason runs one
 *    step a cycle, so without (3) intentions pile up. If all commands were awaited, a plan that loops on `argo.act` would starve sensing.
 *    Any thread may call [isDone], [kindLeft], [waitingEvents] and [dueInMs]; the rest belongs to the agent's thread.
 * @property commands the commands that the board holds
 * @param nowMs a clock in ms that never goes back
 * @param isOwn returns whether a percept belongs to the board, or to none that the agent perceives; called by any thread
 */
internal class EarlierWork(
    val commands: CommandLedger,
    private val queues: ReasoningQueues = ReasoningQueues(),
    private val nowMs: () -> Long = Platform.system.nowMs,
    private val isOwn: (Literal) -> Boolean = { true },
) {
    /** The percept events in the queue when the last snapshot was taken in; null: it has not been taken in, or the queue stands. */
    @Volatile
    private var events: Set<Event>? = null

    /** The time of the last hand-over; null: none yet. */
    @Volatile
    private var handedOverMs: Long? = null

    @Volatile
    private var lastCommand = 0L
    private val deadlines = ConcurrentHashMap<Intention, Long>() // the time in ms until which each intention is awaited

    /** The number of events in Jason's queue, of any kind. */
    val waitingEvents: Int get() = queues.events().size

    /** Notes that a snapshot is being handed over: the work that it leaves is awaited from now on. */
    fun begin() {
        lastCommand = commands.lastIssued()
        events = null
        handedOverMs = nowMs()
    }

    /** Notes that the last snapshot has been taken in: events that join the queue later do not belong to it. */
    fun takenIn() {
        if (events != null || queues.isStanding()) return // once for each snapshot: an atomic plan can leave tens of thousands of events
        events = queues.events().filterTo(Collections.newSetFromMap(IdentityHashMap())) { awaits(it) }
    }

    /**
     * Returns true if no work is left.
     * @param isAwaited true: the agent's thread asks because a snapshot waits. Such a call limits the time for which the agent awaits
     * intentions, if only intentions are left
     */
    fun isDone(isAwaited: Boolean = false): Boolean = kindLeft(isAwaited) == null

    private fun limit(begun: Collection<Intention>) {
        val now = nowMs()
        val deadline = now + maxOf(LONG_MS, now - (handedOverMs ?: now))
        deadlines.keys.retainAll(begun.toSet())
        begun.forEach { deadlines.putIfAbsent(it, deadline) }
    }

    /** Returns the kind of work that is left, in words; null: none. */
    fun kindLeft(): String? = kindLeft(isAwaited = false)

    private fun kindLeft(isAwaited: Boolean): String? {
        if (!commands.allDoneUpTo(lastCommand)) return "commands issued before the last percepts have not left"
        if (!areEventsDone()) return "events of earlier percepts wait"
        val begun = begun()
        if (isAwaited) limit(begun)
        return if (begun.any(::awaits)) "plans that earlier percepts have begun still run" else null
    }

    /** Returns the ms until commands to other boards are no longer awaited; null: none are awaited. */
    fun dueInMs(): Long? = commands.dueInMs(lastCommand)

    private fun areEventsDone() =
        if (queues.isStanding()) handedOverMs.let { it == null || nowMs() - it >= ATOMIC_PLAN_INTERVAL_MS }
        else events?.isEmpty() == true || queues.events().none(::awaits)

    private fun awaits(event: Event): Boolean = events?.contains(event) ?: (isPerceptEvent(event) && isOwn(event.trigger.literal))

    private fun awaits(intention: Intention): Boolean = deadlines[intention]?.let { nowMs() < it } ?: true

    private fun begun(): List<Intention> = if (queues.isStanding()) emptyList() else queues.running().filter { intention ->
        beginningOf(intention)?.let { it.hasSource(BeliefBase.APercept) && isOwn(it) } == true
    }

    /** Returns the event that began [intention]; null: the intention has finished, perhaps during this call. */
    private fun beginningOf(intention: Intention): Literal? = try {
        intention.bottom?.trigger?.literal
    } catch (_: NoSuchElementException) {
        null
    }

    companion object {
        /** The least ms between two hand-overs while Jason takes no event, as during an atomic plan. */
        const val ATOMIC_PLAN_INTERVAL_MS = 100

        /** The ms for which an intention is awaited; longer if the events of the last snapshot took longer. */
        const val LONG_MS = 1000L
    }
}

/** Returns true if [event] means that a percept came or went. */
internal fun isPerceptEvent(event: Event): Boolean =
    event.isExternal && event.trigger.isUpdate && event.trigger.literal.hasSource(BeliefBase.APercept)
