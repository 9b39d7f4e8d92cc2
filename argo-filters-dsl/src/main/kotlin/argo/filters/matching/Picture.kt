package argo.filters.matching

import java.util.BitSet

/**
 * The percepts of one picture of the world, in their order.
 *
 * @property received the percepts as they came
 * @property standing the percepts that stand for the received ones, at the same places
 * @param doubted the places of received percepts that are not credible, so that older ones stand for them
 */
internal class Picture<P>(val received: List<P>, val standing: List<P> = received, private val doubted: BitSet = BitSet()) {
    /** Returns the received percepts, and the percepts that stand for credible ones. */
    fun seen(): Set<P> = received.toHashSet().apply {
        if (standing !== received) standing.forEachIndexed { place, percept -> if (!doubted[place]) add(percept) }
    }

    /** Returns the place of each of [percepts] that was received. */
    fun placesOf(percepts: Set<P>): Map<P, Int> =
        received.indices.filter { received[it] in percepts }.associateBy { received[it] }

    /** Returns true if the percept at [place] is not credible, so that an older one stands for it. */
    fun isDoubted(place: Int): Boolean = doubted[place]

    /** True if some received percept is not credible. */
    val hasDoubted: Boolean get() = !doubted.isEmpty
}
