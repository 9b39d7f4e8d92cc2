package argo.filters.matching

import java.util.BitSet

/** The percepts of one message and their replacements. A picture can be filled again without allocation. */
internal class Picture<P> {
    /** The unchanged percepts. */
    var received: List<P> = emptyList()
        private set

    private val standing = ArrayList<P>() // replacements of the first received percepts; the others are not replaced
    private val doubted = BitSet()

    /** Starts a new picture with the percepts [received]. [stand] replaces the received percepts one by one. */
    fun begin(received: List<P>) {
        this.received = received
        standing.clear()
        doubted.clear()
    }

    /**
     * Replaces the next received percept by [percept]. The first call replaces the first received percept.
     *
     * @param isDoubted whether the received percept is not credible
     */
    fun stand(percept: P, isDoubted: Boolean) {
        if (isDoubted) doubted.set(standing.size)
        standing += percept
    }

    /** Returns the percept that replaces the one at index [place], or the received percept itself. */
    fun standing(place: Int): P = if (place < standing.size) standing[place] else received[place]

    /** Returns the received percepts, and the percepts that replace credible ones. */
    fun seen(): Set<P> = received.toHashSet().apply {
        standing.forEachIndexed { place, percept -> if (!doubted[place]) add(percept) }
    }

    /** Returns the indices at which [percepts] were received. */
    fun placesOf(percepts: Set<P>): Map<P, Int> =
        received.indices.filter { received[it] in percepts }.associateBy { received[it] }

    /** Returns true if the percept at index [place] is not credible, so an older percept replaces it. */
    fun isDoubted(place: Int): Boolean = doubted[place]

    /** True if some received percept is not credible. */
    val hasDoubted: Boolean get() = !doubted.isEmpty
}
