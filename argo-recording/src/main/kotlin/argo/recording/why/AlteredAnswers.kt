package argo.recording.why

import argo.boundary.InternalCall
import argo.filters.jason.perceptText
import argo.recording.Cycle
import argo.recording.End
import argo.recording.KeyFrame
import argo.recording.replay.Answers
import argo.recording.replay.BegunWork
import argo.recording.replay.RecordedAnswers
import argo.recording.replay.RecordedSenses
import argo.recording.replay.ReplayedInputs
import argo.recording.replay.Senses
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm
import java.util.concurrent.Callable

/** Something that an agent began outside of its thread: in which cycle, of which kind, and what. */
internal data class Beginning(val cycle: Long, val kind: String, val what: String)

/** What was [recorded]; it notes what the agent begins outside of its thread, in that order. */
internal class NotingAnswers(private val recorded: RecordedAnswers) : Answers by recorded {
    /** What the agent has begun. */
    val begun = ArrayList<Beginning>()

    override fun begun(work: BegunWork) {
        begun += Beginning(work.cycle.index, work.kind, work.what)
        recorded.begun(work)
    }
}

/** What was recorded, with percepts [changed]. */
internal class AlteredSenses(private val changed: (List<Literal>) -> List<Literal>) : Senses {
    private val recorded = RecordedSenses()

    override fun begin(percepts: List<Literal>) = recorded.begin(percepts)

    override fun perceive(cycle: Cycle): List<Literal>? = recorded.perceive(cycle)?.let(changed)

    override fun takeNewlyCritical(): List<Literal> = recorded.takeNewlyCritical()
}

/**
 * What was [recorded], for an agent that perceives something else. What it begins as it did ends as it did. What it begins besides ends
 * well: a timer at its time, all else in its next cycle.
 *
 * @param begun what the recorded agent began outside of its thread
 * @param before how many things it had begun before that
 * @param issued takes the text of a command that was not recorded
 */
internal class AlteredAnswers(
    private val recorded: RecordedAnswers,
    begun: List<Beginning>,
    before: Int,
    private val issued: (String) -> Unit,
) : Answers by recorded {
    private class Open(val dueNs: Long, val work: BegunWork)

    private val expected = begun.withIndex().groupByTo(HashMap(), { it.value }, { before + it.index + 1 })
        .mapValues { ArrayDeque(it.value) }
    private val open = HashMap<Int, (End) -> Unit>()
    private val besides = ArrayList<Open>()

    init {
        recorded.unrecorded = ::unrecorded
    }

    /** When the first thing ends that was not recorded, in ns of the agent's clock; null: none is under way. */
    val dueNs: Long? get() = besides.minOfOrNull { it.dueNs }

    override fun begin(inputs: ReplayedInputs, start: KeyFrame?, timers: Map<Int, Callable<*>>) {
        timers.forEach { (number, work) -> open[number] = { work.call() } }
    }

    override fun begun(work: BegunWork) {
        val number = expected[Beginning(work.cycle.index, work.kind, work.what)]?.removeFirstOrNull()
        if (number != null) open[number] = work.complete else besides += Open(work.cycle.ns + work.delayNs, work)
    }

    override fun carryOut(cycle: Cycle) {
        val (ofThreads, ends) = cycle.input.ends.partition { it.number == 0 }
        ofThreads.forEach(recorded::carryOut)
        ends.forEach { open.remove(it.number)?.invoke(it) }
        val due = besides.filter { it.dueNs <= cycle.ns }
        besides -= due.toSet()
        due.sortedBy { it.dueNs }.forEach { it.work.complete(End(0, it.work.kind)) }
    }

    private fun unrecorded(call: InternalCall): Any {
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
