package argo.filters.matching

import java.util.BitSet

/** The percepts of one picture of the world, in their order. It can be filled again, which allocates nothing. */
internal class Picture<P> {
    /** The percepts as they came. */
    var received: List<P> = emptyList()
        private set

    private val standing = ArrayList<P>() // for the first ones received; each further one stands for itself
    private val doubted = BitSet()

    /** Makes this the picture of [received], each of which stands for itself until [stand] is called. */
    fun begin(received: List<P>) {
        this.received = received
        standing.clear()
        doubted.clear()
    }

    /** Has [percept] stand for the first received one for which [stand] has not been called. If [isDoubted], that one is not credible. */
    fun stand(percept: P, isDoubted: Boolean) {
        if (isDoubted) doubted.set(standing.size)
        standing += percept
    }

    /** Returns the percept that stands for the one received at [place]. */
    fun standing(place: Int): P = if (place < standing.size) standing[place] else received[place]

    /** Returns the received percepts, and the percepts that stand for credible ones. */
    fun seen(): Set<P> = received.toHashSet().apply {
        standing.forEachIndexed { place, percept -> if (!doubted[place]) add(percept) }
    }

    /** Returns the place of each of [percepts] that was received. */
    fun placesOf(percepts: Set<P>): Map<P, Int> =
        received.indices.filter { received[it] in percepts }.associateBy { received[it] }

    /** Returns true if the percept at [place] is not credible, so that an older one stands for it. */
    fun isDoubted(place: Int): Boolean = doubted[place]

    /** True if some received percept is not credible. */
    val hasDoubted: Boolean get() = !doubted.isEmpty
}
