package argo.recording.replay

import argo.Arch
import argo.boundary.Boundary
import argo.observing.AgentObserver
import argo.observing.ObservedAgent
import argo.recording.Cycle
import argo.recording.RecordedAgent
import argo.recording.agent.restoreIn
import jason.asSemantics.TransitionSystem

/**
 * A recorded agent that Jason runs again on its recorded input, without ports, threads and its own clock. The agent begins at the beginning
 * of its program, or at the key frame [Recording.start] of [recording].
 *
 * @param programs the files of the agents' programs, with checked code
 * @param isChecking whether to carry out the project's code
 * @param observers options of observers, such as `argo_debug=4711`
 * @param boundaryOf returns the boundary of the agent: its inputs, or an observer around them
 */
internal class ReplayedAgent(
    private val recording: Recording,
    val recorded: RecordedAgent,
    programs: ProgramFiles,
    private val found: (Difference) -> Unit,
    private val isChecking: Boolean = false,
    observers: Map<String, String> = emptyMap(),
    boundaryOf: (ReplayedInputs, RecordedAnswers) -> Boundary = { inputs, _ -> inputs },
) : AutoCloseable {
    private val answers = RecordedAnswers(isChecking, ::report)
    private val inputs = ReplayedInputs(answers)
    private val includes = RecordedIncludes(recording, recorded.name)
    val ts: TransitionSystem =
        jasonAgent(recorded, programs.of(recorded.name), includes, boundaryOf(inputs, answers), isChecking, observers)
    private val arch get() = ts.agArch as Arch

    val observed: ObservedAgent get() = arch.observed

    val observers: List<AgentObserver> get() = arch.observers
    private val start = recording.start(recorded.name)
    private val seen = LinkedHashSet<String>() // names of the project's threads seen so far
    private var lastIndex = start?.index ?: 0L
    private var lastNumber = start?.number

    init {
        if (start == null) recorded.beginning?.restoreIn(ts)
        inputs.begin(ts, start)
    }

    fun run(cycle: Cycle) {
        recording.requireNext(recorded.name, cycle, lastIndex, isChecking)
        lastIndex = cycle.index
        lastNumber?.let { ts.rest(cycle.number - it - 1) }
        lastNumber = cycle.number
        seen += threadsIn(cycle)
        inputs.next(cycle)
        ts.cycle(cycle.number, recorded.isConditional, includes)
        val now = inputs.end().asFarAs(cycle, isChecking)
        difference(cycle.course, now)?.let { (what, before, after) -> report(what, before, after, null) }
    }

    private fun report(what: String, before: String?, now: String?, cause: String?): Unit =
        found(Difference(recorded.name, inputs.cycle.number, inputs.cycle.ns, what, before, now, cause ?: likelyCause()))

    private fun likelyCause(): String = missingAction()?.let { "the project's class $it is not on the class path; add it" } ?: when {
        seen.isNotEmpty() -> "${seen.joinToString()} works on the agent, and its work within a cycle is not recorded"
        answers.projectCalls.isNotEmpty() ->
            "the effects of the project's own ${answers.projectCalls.joinToString()} besides results are not recorded, and happen only " +
                "with --check"
        else -> "not known; it is the first difference of this agent"
    }

    private fun threadsIn(cycle: Cycle): List<String> = buildList {
        cycle.input.ends.mapNotNull { it.thread }.forEach { add("the project's thread $it") }
        if (cycle.input.events.isNotEmpty() || cycle.input.isChangedOutside) add("a thread of the project")
    }

    private fun missingAction(): String? =
        inputs.cycle.input.calls.filter { it.isOfProject }.map { it.name }.find { classOrNull(it) == null }

    override fun close() {
        inputs.course.close()
        ts.end()
    }
}

/** Returns the reason, in words, why [cycle] of [agent] cannot follow the cycle with the index [last]; null if it can. */
internal fun gap(agent: String, cycle: Cycle, last: Long) =
    "the recording of agent $agent has a gap of ${cycle.index - last - 1} cycles before cycle ${cycle.number}: " +
        "the disk was too slow, or that part of the file is damaged; until there it can be replayed"
