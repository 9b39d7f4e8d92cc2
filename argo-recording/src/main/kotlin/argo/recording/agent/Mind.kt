package argo.recording.agent

import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.LogicalFormula
import jason.asSyntax.Plan
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import java.io.Serializable

/** What an agent has in mind at the end of a cycle: its events, its intentions with what they wait for, and its plans. */
internal class Mind(
    val events: ArrayList<Event>,
    val atomicEvent: Event?,
    val running: ArrayList<Intention>,
    val atomic: Intention?,
    val isAtomicSuspended: Boolean,
    val pending: LinkedHashMap<String, Intention>,
    val pendingEvents: LinkedHashMap<String, Event>,
    val goalConditions: Int,
    /** What the last cycle chose; a cycle that has nothing to choose leaves it. */
    val event: Event?,
    val plan: Plan?,
    val intention: Intention?,
    val waits: ArrayList<Wait>,
    /** The intentions that have been numbered, and their numbers. */
    val numbered: ArrayList<Intention>,
    val numbers: ArrayList<Int>,
    /** The agent's plans; null: those of its program. */
    val plans: ArrayList<Plan>?,
) : Serializable {
    private companion object {
        const val serialVersionUID = 1L
    }
}

/**
 * A `.wait` of Jason's.
 *
 * @property timer the number of its timer; null: none is under way
 * @property isListening whether it waits still: a timer runs on when its `.wait` has ended
 */
internal class Wait(
    val timer: Int?,
    val isListening: Boolean,
    val trigger: Trigger?,
    val formula: LogicalFormula?,
    val reason: Literal,
    val key: String,
    val un: Unifier,
    val intention: Intention,
    val isDropped: Boolean,
    val elapsed: Term?,
) : Serializable {
    private companion object {
        const val serialVersionUID = 1L
    }
}
