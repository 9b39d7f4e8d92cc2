package argo.boards

import jason.asSyntax.Literal
import jason.bb.StructureWrapperForLiteral

/**
 * What an agent believes of a board, and believed of it before the last snapshot. Does not change, so that who reads it sees no half of a
 * change.
 *
 * @property nanos when the readings in [percepts] came, by the platform's clock; null: there are none
 */
internal class BelievedPercepts private constructor(val percepts: List<Literal>, val nanos: Long?, private val before: List<Literal>) {
    private val keys by lazy(LazyThreadSafetyMode.PUBLICATION) { (percepts + before).mapTo(HashSet(), ::StructureWrapperForLiteral) }

    /** Whether [percept], whose annotations do not matter, is believed, or was before. */
    operator fun contains(percept: Literal): Boolean = StructureWrapperForLiteral(percept) in keys

    /** What is believed after this. */
    fun then(percepts: List<Literal>, nanos: Long?) = BelievedPercepts(percepts, nanos, this.percepts)

    companion object {
        val NONE = BelievedPercepts(emptyList(), null, emptyList())
    }
}
