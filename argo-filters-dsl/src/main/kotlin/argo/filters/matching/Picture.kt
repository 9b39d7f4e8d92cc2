package argo.filters.matching

import java.util.BitSet

/** The percepts of one message, each with the percept that replaces it. It can be filled again, without allocation. */
internal class Picture<P> {
    /** The percepts as they came. */
    var received: List<P> = emptyList()
        private set

    private val standing = ArrayList<P>() // the replacements of the first received percepts; others are not replaced
    private val doubted = BitSet()

    /** Begins anew with the percepts [received]. A percept is not replaced until [stand] is called for it. */
    fun begin(received: List<P>) {
        this.received = received
        standing.clear()
        doubted.clear()
    }

    /** Replaces the next received percept by [percept]; the first call is for the first one. If [isDoubted], that one is not credible. */
    fun stand(percept: P, isDoubted: Boolean) {
        if (isDoubted) doubted.set(standing.size)
        standing += percept
    }

    /** Returns the percept that replaces the one received at index [place]; that percept itself if it is not replaced. */
    fun standing(place: Int): P = if (place < standing.size) standing[place] else received[place]

    /** Returns the received percepts, and the percepts that replace credible ones. */
    fun seen(): Set<P> = received.toHashSet().apply {
        standing.forEachIndexed { place, percept -> if (!doubted[place]) add(percept) }
    }

    /** Returns the index of each of [percepts] that was received. */
    fun placesOf(percepts: Set<P>): Map<P, Int> =
        received.indices.filter { received[it] in percepts }.associateBy { received[it] }

    /** Returns true if the percept at index [place] is not credible, so that an older one replaces it. */
    fun isDoubted(place: Int): Boolean = doubted[place]

    /** True if some received percept is not credible. */
    val hasDoubted: Boolean get() = !doubted.isEmpty
}
