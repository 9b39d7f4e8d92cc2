package argo.filters.matching

import java.util.BitSet

/**
 * The percepts of one picture of the world, in their order.
 *
 * @property received the percepts as they came
 * @property standing the percepts that stand for them
 * @param doubted the places of those for which an older one stands, since they are not credible
 */
internal class Picture<P>(val received: List<P>, val standing: List<P> = received, private val doubted: BitSet = BitSet()) {
    /** Returns the percepts that have come with this picture, or stand for such a one. */
    fun seen(): Set<P> = received.toHashSet().apply {
        if (standing !== received) standing.forEachIndexed { place, percept -> if (!doubted[place]) add(percept) }
    }

    /** Returns the place of each of [percepts] that came. */
    fun placesOf(percepts: Set<P>): Map<P, Int> =
        received.indices.filter { received[it] in percepts }.associateBy { received[it] }

    /** Returns true if an older percept stands for the one at [place], which is not credible. */
    fun isDoubted(place: Int): Boolean = doubted[place]

    /** True if an older percept stands for one that is not credible. */
    val hasDoubted: Boolean get() = !doubted.isEmpty
}
