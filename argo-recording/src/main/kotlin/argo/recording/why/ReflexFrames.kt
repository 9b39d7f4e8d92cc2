package argo.recording.why

import argo.recording.Cycle
import argo.recording.ReflexEnd

/**
 * Finds the frame that caused a reflex, among the frames that an agent perceived.
 *
 * @param cycles the replayed cycles; frames are counted from the first of them
 * @param filters the filters at the beginning of the first of [cycles]
 */
internal class ReflexFrames(private val cycles: List<Cycle>, private val filters: RecordedFilters, private val clock: RecordingClock) {
    fun cause(command: RecordedCommand, reflex: ReflexEnd): ReflexCause {
        val all = percepts(command, reflex)
        // Takes the newest frame up to the command or, without one, the next frame. An agent may take a board's report before the frame.
        val frame = all.lastOrNull { it.seconds <= command.seconds } ?: all.firstOrNull { it.seconds - command.seconds <= LATE_S }
        return ReflexCause(reflex.rule, reflex.isByBoard, reflex.failure?.message, frame)
    }

    private fun percepts(command: RecordedCommand, reflex: ReflexEnd): List<PerceptCause> {
        val frames = Frames(clock::seconds)
        return cycles.flatMap { cycle ->
            val found = cycle.input.snapshots.mapNotNull { snapshot ->
                val frame = frames.of(snapshot, cycle.number)
                if (command.port != null && command.port != snapshot.port) return@mapNotNull null
                val met = filters.critical(snapshot.port, snapshot.texts, snapshot.kept ?: snapshot.texts)
                    .find { it.rule.reflex == reflex.command && "${it.rule.rule}" == reflex.rule } ?: return@mapNotNull null
                val belief = believed(met.percept, snapshot.namespace)?.let(::keyOf) ?: met.percept
                val why = filters.explain(snapshot.port, met.percept)?.toString()
                PerceptCause(belief, seconds = frame.seconds, frame = frame, filter = why)
            }
            filters.changed(cycle.input.filters)
            found
        }
    }

    private companion object {
        const val LATE_S = 0.5
    }
}
