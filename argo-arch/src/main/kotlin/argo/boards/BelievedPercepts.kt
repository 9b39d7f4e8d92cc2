package argo.boards

import jason.asSyntax.Literal
import jason.bb.StructureWrapperForLiteral

/**
 * The percepts of a board that an agent believes, and those of the snapshot before. Immutable, so no reader sees half a change.
 * @property nanos the arrival time of the readings in [percepts], by the platform's clock; null: [percepts] has no readings
 */
internal class BelievedPercepts private constructor(val percepts: List<Literal>, val nanos: Long?, private val before: List<Literal>) {
    private val keys by lazy(LazyThreadSafetyMode.PUBLICATION) { (percepts + before).mapTo(HashSet(), ::StructureWrapperForLiteral) }

    /** Returns true if [percept] is believed, or was before the last snapshot. Annotations do not matter. */
    operator fun contains(percept: Literal): Boolean = StructureWrapperForLiteral(percept) in keys

    fun then(percepts: List<Literal>, nanos: Long?) = BelievedPercepts(percepts, nanos, this.percepts)

    companion object {
        val NONE = BelievedPercepts(emptyList(), null, emptyList())
    }
}
