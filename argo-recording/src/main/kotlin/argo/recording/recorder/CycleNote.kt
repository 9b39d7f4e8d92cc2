package argo.recording.recorder

import argo.recording.Cycle
import argo.recording.agent.CourseNote

/** A recorded cycle; the thread that stores it makes its texts. Immutable. */
internal class CycleNote(
    val index: Long,
    val number: Int,
    private val notes: CycleNotes,
    private val course: CourseNote,
    private val isEnding: Boolean,
    private val missesPrints: Boolean,
) {
    val ns: Long = notes.ns

    /** The number of percepts in the cycle. */
    val percepts: Int get() = notes.percepts?.size ?: 0

    /** Makes the texts, on any thread. */
    fun cycle() = Cycle(index, number, ns, notes.counters, notes.input(), course.course(), isEnding, missesPrints, notes.refusal)
}
