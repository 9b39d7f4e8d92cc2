package argo.boards

import jason.asSyntax.Literal
import jason.bb.StructureWrapperForLiteral

/**
 * The percepts of a board that an agent believes, and those that it believed before the last snapshot. Immutable.
 *
 * @property nanos the time at which [percepts] arrived, by the platform's clock; null if there are none
 */
internal class BelievedPercepts private constructor(val percepts: List<Literal>, val nanos: Long?, private val before: List<Literal>) {
    private val keys by lazy(LazyThreadSafetyMode.PUBLICATION) { (percepts + before).mapTo(HashSet(), ::StructureWrapperForLiteral) }

    /** Returns true if the agent believes [percept], or believed it before the last snapshot. Ignores annotations. */
    operator fun contains(percept: Literal): Boolean = StructureWrapperForLiteral(percept) in keys

    fun then(percepts: List<Literal>, nanos: Long?) = BelievedPercepts(percepts, nanos, this.percepts)

    companion object {
        val NONE = BelievedPercepts(emptyList(), null, emptyList())
    }
}
