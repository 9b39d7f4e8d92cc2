package argo.tools.replay

import argo.recording.KeyFrame
import argo.recording.replay.Difference
import argo.recording.replay.RefusedCycle
import argo.tools.command.counted
import argo.tools.command.jsonOf
import argo.tools.command.secondsIn
import kotlinx.serialization.json.JsonObject

/**
 * The result of a replay.
 *
 * @property beginnings the state from which the replay goes on, for each agent whose first cycles are missing
 * @property recordedNs the time from the first cycle to the last replayed cycle
 * @property refusals the cycles that cannot be replayed. Each ends the replay of its agent
 * @property beliefs the beliefs of the requested agents
 * @property problems a sentence for each part that was not replayed
 */
internal class ReplayReport(
    private val agents: List<String>,
    private val beginnings: Map<String, KeyFrame>,
    private val cycles: Long,
    private val firstNs: Long,
    private val recordedNs: Long,
    private val elapsedNs: Long,
    differences: List<Difference>,
    private val refusals: List<RefusedCycle>,
    private val beliefs: Map<String, List<String>>,
    private val shown: List<ShownCycle>,
    val problems: List<String>,
) {
    private val course = differences.filterNot { it.isOfResult }

    /** For each agent and kind of difference in results: the first difference, and the number of differences. */
    private val results = differences.filter { it.isOfResult }.groupBy { it.agent to it.what }.values.map { it.first() to it.size }

    val isIdentical: Boolean get() = course.isEmpty()

    val isWhole: Boolean get() = refusals.isEmpty()

    /** True if the agents acted as recorded, and if all actions and functions gave the recorded results. */
    val isDeterministic: Boolean get() = isIdentical && results.isEmpty()

    /** Returns the report on the recording [name]. With [isCheck], includes everything that is not deterministic. */
    fun lines(name: String, isCheck: Boolean): List<String> = buildList {
        add("$name: ${if (agents.size == 1) "agent" else "agents"} ${agents.joinToString()}")
        beginnings.forEach { (agent, frame) ->
            val of = if (agents.size == 1) "" else "agent $agent "
            add("${of}begins behind cycle ${frame.number}, %.3f s: earlier cycles are not in this recording".format(secondsAt(frame.ns)))
        }
        add("${counted(cycles, "cycle")} of %.3f s replayed in %.3f s%s".format(secondsIn(recordedNs), secondsIn(elapsedNs), pace()))
        refusals.forEach { add("refused: agent ${it.agent}, from cycle ${it.cycle}, %.3f s, on: ".format(secondsAt(it.ns)) + it.why) }
        course.forEach { addAll(described("differs", it)) }
        if (isIdentical && (cycles > 0 || isWhole)) {
            val part = if (isWhole && problems.isEmpty()) "" else " as far as it goes"
            add("identical$part: the same events, plans, steps, calls, actions and messages in each of them")
        }
        if (isCheck) {
            results.forEach { (first, times) -> addAll(described("not deterministic${if (times > 1) ", $times times" else ""}", first)) }
            if (isDeterministic) add("nothing in it gave another result")
        }
        shown.forEach { add("%9.3f s  ".format(secondsAt(it.cycle.ns)) + it.words()) }
        for ((agent, believed) in beliefs) {
            add(if (believed.isEmpty()) "$agent believes nothing" else "$agent believes:")
            believed.forEach { add("  $it") }
        }
    }

    fun json(): JsonObject = jsonOf(
        "agents" to agents,
        "begins" to beginnings.map { (agent, frame) ->
            jsonOf("agent" to agent, "cycle" to frame.number, "seconds" to secondsAt(frame.ns))
        },
        "cycles" to cycles, "seconds" to secondsIn(recordedNs), "took" to secondsIn(elapsedNs),
        "identical" to isIdentical, "deterministic" to isDeterministic, "problems" to problems,
        "refused" to refusals.map {
            jsonOf("agent" to it.agent, "cycle" to it.cycle, "seconds" to secondsAt(it.ns), "why" to it.why)
        },
        "differences" to (course.map { it to 1 } + results).map { (difference, times) -> jsonOf(difference, times) },
        "shown" to shown.map { it.json(secondsAt(it.cycle.ns)) },
        "beliefs" to jsonOf(*beliefs.toList().toTypedArray()),
    )

    private fun jsonOf(it: Difference, times: Int) = jsonOf(
        "agent" to it.agent, "cycle" to it.cycle, "seconds" to secondsAt(it.ns), "what" to it.what, "times" to times,
        "recorded" to it.recorded, "now" to it.now, "cause" to it.cause,
    )

    private fun described(how: String, it: Difference) = listOf(
        "$how: agent ${it.agent}, cycle ${it.cycle}, %.3f s, ${it.what.replace("%", "%%")}".format(secondsAt(it.ns)),
        "  recorded: ${it.recorded ?: "nothing"}",
        "  now:      ${it.now ?: "nothing"}",
        "  likely:   ${it.cause}",
    )

    private fun secondsAt(ns: Long) = secondsIn(ns - firstNs)

    private fun pace() = if (recordedNs > 0 && elapsedNs > 0) ", %.0f times real time".format(recordedNs.toDouble() / elapsedNs) else ""
}
