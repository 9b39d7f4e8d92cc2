package argo.recording.recorder

import argo.recording.Cycle
import argo.recording.agent.CourseNote

/** A recorded cycle, whose texts are made by the thread that stores it. Nothing of it changes. */
internal class CycleNote(
    val index: Long,
    val number: Int,
    private val notes: CycleNotes,
    private val course: CourseNote,
    private val isEnding: Boolean,
    private val missesPrints: Boolean,
) {
    val ns: Long = notes.ns

    /** How many percepts it holds. */
    val percepts: Int get() = notes.percepts?.size ?: 0

    /** Any thread. */
    fun cycle() = Cycle(index, number, ns, notes.counters, notes.input(), course.course(), isEnding, missesPrints)
}
