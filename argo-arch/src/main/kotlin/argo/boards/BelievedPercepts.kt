package argo.boards

import jason.asSyntax.Literal
import jason.bb.StructureWrapperForLiteral

/**
 * The percepts of a board that an agent believes, and those that it believed before the last snapshot. Immutable, so that no reader sees
 * half a change.
 *
 * @property nanos the time at which the readings in [percepts] came, by the platform's clock; null: there are none
 */
internal class BelievedPercepts private constructor(val percepts: List<Literal>, val nanos: Long?, private val before: List<Literal>) {
    private val keys by lazy(LazyThreadSafetyMode.PUBLICATION) { (percepts + before).mapTo(HashSet(), ::StructureWrapperForLiteral) }

    /** Returns true if [percept], whose annotations do not matter, is believed, or was believed before the last snapshot. */
    operator fun contains(percept: Literal): Boolean = StructureWrapperForLiteral(percept) in keys

    /** Returns the beliefs after the next snapshot. */
    fun then(percepts: List<Literal>, nanos: Long?) = BelievedPercepts(percepts, nanos, this.percepts)

    companion object {
        val NONE = BelievedPercepts(emptyList(), null, emptyList())
    }
}
