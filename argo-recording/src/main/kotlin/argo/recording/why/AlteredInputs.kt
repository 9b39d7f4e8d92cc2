package argo.recording.why

import argo.boundary.InternalCall
import argo.filters.jason.perceptText
import argo.recording.End
import argo.recording.replay.DifferenceSink
import argo.recording.replay.ReplayedInputs
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm

/** Something that an agent began outside of its thread: in which cycle, of which kind, and what. */
internal data class Beginning(val cycle: Long, val kind: String, val what: String)

/** The recorded inputs; it notes what the agent begins outside of its thread, in that order. */
internal class NotingInputs(found: DifferenceSink) : ReplayedInputs(found) {
    /** What the agent has begun. */
    val begun = ArrayList<Beginning>()

    override fun begin(kind: String, what: String, delayNs: Long, complete: (End) -> Unit): Int {
        begun += Beginning(cycle.index, kind, what)
        return super.begin(kind, what, delayNs, complete)
    }
}

/**
 * The recorded inputs, but for percepts. What the agent begins as it did ends as it did. What it begins besides ends well: a timer at its
 * time, all else in its next cycle.
 *
 * @param begun what the recorded agent began outside of its thread
 * @param before how many things it had begun before that
 * @param changed the percepts in place of those that were recorded
 * @param issued takes the text of a command that was not recorded
 */
internal class AlteredInputs(
    begun: List<Beginning>,
    before: Int,
    private val changed: (List<Literal>) -> List<Literal>,
    private val issued: (String) -> Unit,
) : ReplayedInputs({ _, _, _, _ -> }) {
    private class Open(val kind: String, val dueNs: Long, val complete: (End) -> Unit)

    private val expected = begun.withIndex().groupByTo(HashMap(), { it.value }, { before + it.index + 1 })
        .mapValues { ArrayDeque(it.value) }
    private val recorded = HashMap<Int, (End) -> Unit>()
    private val besides = ArrayList<Open>()
    private var others = 0

    /** When the first thing ends that was not recorded, in ns of the agent's clock; null: none is under way. */
    val dueNs: Long? get() = besides.minOfOrNull { it.dueNs }

    override fun begin(kind: String, what: String, delayNs: Long, complete: (End) -> Unit): Int {
        val number = expected[Beginning(cycle.index, kind, what)]?.removeFirstOrNull()
        if (number != null) recorded[number] = complete
        else besides += Open(kind, cycle.ns + delayNs, complete)
        return number ?: --others
    }

    override fun restore(last: Int, open: Map<Int, (End) -> Unit>) {
        recorded += open
    }

    override fun carryOut(ends: List<End>) {
        super.carryOut(ends.filter { it.number == 0 })
        ends.forEach { recorded.remove(it.number)?.invoke(it) }
        val due = besides.filter { it.dueNs <= cycle.ns }
        besides -= due.toSet()
        due.sortedBy { it.dueNs }.forEach { it.complete(End(0, it.kind)) }
    }

    override fun perceived(percepts: List<Literal>): List<Literal> = changed(percepts)

    override fun unrecorded(call: InternalCall): Any {
        if (!call.name.startsWith("argo.")) return false
        if (call.name == "argo.act") issued(textOfCommand(call))
        call.suspend?.invoke()
        return call.suspend != null || call.name in ALWAYS
    }

    private fun textOfCommand(call: InternalCall) = when (val command = call.args[0]) {
        is StringTerm -> command.string
        is Literal -> perceptText(command.cloneNS(Literal.DefaultNS) as Literal)
        else -> "$command"
    }

    private companion object {
        /** Actions that succeed at once. */
        val ALWAYS = setOf("argo.percepts", "argo.limit", "argo.change_filter", "argo.record")
    }
}
