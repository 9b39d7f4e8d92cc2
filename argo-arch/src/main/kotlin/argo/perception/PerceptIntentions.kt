package argo.perception

import argo.platform.Platform
import argo.platform.nowMs
import jason.asSemantics.Intention
import jason.asSyntax.Literal
import jason.bb.BeliefBase
import java.util.concurrent.ConcurrentHashMap

/**
 * Tracks if the intentions that percept events of a board have begun are worked off. Jason takes one event a cycle and runs one step of one
 * intention. So plans of more steps than that would pile up as intentions, and each would wait for its turn behind all the others.
 *
 * An intention is worked off when it has finished or waits, as for the outcome of a command. One that still runs after [LONG_MS] is meant
 * to run on, and is not awaited any more. Any thread may call [wait]; the rest belongs to the agent's.
 *
 * @param nowMs a clock in ms that never goes back
 * @param isOwn whether a percept is of the board, or of none that the agent perceives; asked by any thread
 * @param running the agent's intentions that wait for their next step, which any thread may go through
 */
internal class PerceptIntentions(
    private val nowMs: () -> Long = Platform.system.nowMs,
    private val isOwn: (Literal) -> Boolean = { true },
    private val running: () -> Collection<Intention> = { emptyList() },
) {
    private val deadlines = ConcurrentHashMap<Intention, Long>() // until when each is awaited
    private var handedOverMs = nowMs()

    /** Notes that a snapshot is being handed over. */
    fun handedOver() {
        handedOverMs = nowMs()
    }

    /** Notes that a snapshot waits only for these intentions. Those that are awaited now are awaited for a limited time. */
    fun await() {
        val now = nowMs()
        val begun = begun()
        deadlines.keys.retainAll(begun.toSet())
        val deadline = now + maxOf(LONG_MS, now - handedOverMs)
        for (intention in begun) deadlines.putIfAbsent(intention, deadline)
    }

    /** Returns true if some of the intentions are not worked off. */
    fun wait(): Boolean {
        val now = nowMs()
        return begun().any { intention -> deadlines[intention]?.let { now < it } ?: true }
    }

    private fun begun() = running().filter { intention ->
        beginningOf(intention)?.let { it.hasSource(BeliefBase.APercept) && isOwn(it) } == true
    }

    /** Returns the event that began [intention]; null: it has finished, which its thread may find out at this moment. */
    private fun beginningOf(intention: Intention): Literal? = try {
        intention.bottom?.trigger?.literal
    } catch (_: NoSuchElementException) {
        null
    }

    companion object {
        /** The time for which an intention is awaited, in ms; longer if taking the events of the last snapshot took longer. */
        const val LONG_MS = 1000L
    }
}
