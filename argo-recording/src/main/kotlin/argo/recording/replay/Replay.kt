package argo.recording.replay

import argo.observing.Pausing
import argo.recording.Cycle
import argo.recording.RecordedAgent
import argo.recording.agent.shownBeliefs

/**
 * Runs the agents of [recording] again in Jason on their recorded input, without boards, threads and clocks. The cycles run in the order of
 * their times. After each cycle, the replay compares the agent's course with the recorded one. If an agent takes another course, it is
 * stopped, since its later input answers actions that it has not done. An agent also stops before its first cycle that no replay can
 * repeat, see [refusals].
 *
 * A replay changes nothing outside of itself. Instead of the project's own internal actions and functions, it uses their recorded results.
 * If [isChecking] is true, the replay carries them out and reports results that differ, but still uses the recorded results. If
 * [isChecking] is false, the replay refuses an agent that has an architecture of the project in place of `argo.Arch`.
 *
 * If the beginning of an agent is missing, the agent begins at its own first key frame, see [Recording.start]. The agents need no common
 * key frame, since an agent's recording contains all messages that it took after its own key frame.
 *
 * Close the replay at the end. For one thread. A program can run one replay at a time.
 *
 * @param isChecking whether to carry out the project's own code again
 * @param debugPort the port at which debuggers reach the agents, 0 for any free port; null if no debugger reaches them
 * @throws RecordingException if the recording cannot be replayed, or no debugger can reach an agent at [debugPort]
 */
class Replay(
    private val recording: Recording,
    private val isChecking: Boolean = false,
    private val debugPort: Int? = null,
) : AutoCloseable {
    private val programs = ProgramFiles(recording)
    private val agents = create()
    private val cycles = agents.keys.associateWith { recording.replayable(it).iterator() }
    private val next = HashMap<String, Cycle>()
    private val stopped = HashSet<String>()
    private val differing = ArrayList<Difference>()
    private val refusing = ArrayList<RefusedCycle>()

    /** The differences from the recording so far, in the order of the cycles. */
    val differences: List<Difference> get() = differing

    /** The cycles found so far that no replay can repeat. Each of these cycles ended the replay of its agent. */
    val refusals: List<RefusedCycle> get() = refusing

    var cyclesRun = 0L
        private set

    /** The beginning of the last cycle that was run, in ns of the agents' clock; null if none was run. */
    var lastNs: Long? = null
        private set

    init {
        cycles.keys.forEach(::read)
    }

    private val upcoming: Map.Entry<String, Cycle>? get() = next.minByOrNull { (_, cycle) -> cycle.ns }

    /** The beginning of the next cycle, in ns of the agents' clock; null if none is left. */
    val nextNs: Long? get() = upcoming?.value?.ns

    /**
     * Returns the pauses of [agent] in this replay. While the agent is paused, [run] does not return, so another thread must let the agent
     * continue. A pause does not change the agent's course.
     */
    fun pausing(agent: String): Pausing = agents.getValue(agent).observed.pausing

    /** Pauses the agent of the next cycle before that cycle, see [pausing]. Returns the agent's name; null if no cycle is left. */
    fun pause(): String? = upcoming?.key?.also { pausing(it).pause() }

    /** Runs all cycles that began before [untilNs]. Returns this replay. */
    fun run(untilNs: Long = Long.MAX_VALUE): Replay = apply {
        while (true) {
            val (agent, cycle) = upcoming ?: break
            if (cycle.ns >= untilNs) break
            val refusal = cycle.refusal?.takeUnless { isChecking && it.isOfProject }
            if (refusal == null) runCycle(agent, cycle)
            else {
                refusing += RefusedCycle(agent, cycle, refusal)
                next -= agent
            }
        }
    }

    private fun create() = try {
        recording.agents.values.associate { it.name to agent(it) }
    } catch (failed: Throwable) {
        programs.close()
        throw refusalOf(failed)
    }

    private fun agent(recorded: RecordedAgent): ReplayedAgent {
        val observers = debugPort?.let { mapOf("argo_debug" to "$it") }.orEmpty()
        return ReplayedAgent(recording, recorded, programs, ::found, isChecking, observers).also {
            if (it.observers.size < observers.size) {
                it.close()
                throw RecordingException("no debugger can reach agent ${recorded.name} at port $debugPort; the log says why")
            }
        }
    }

    private fun runCycle(agent: String, cycle: Cycle) {
        try {
            agents.getValue(agent).run(cycle)
        } catch (_: StackOverflowError) {
            throw RecordingException("a term or a rule is nested too deeply in cycle ${cycle.number} of agent $agent")
        } catch (broken: IllegalArgumentException) {
            throw refusalOf(broken)
        }
        cyclesRun++
        lastNs = cycle.ns
        if (agent in stopped) next -= agent else read(agent)
    }

    private fun read(agent: String) {
        val cycles = cycles.getValue(agent)
        if (cycles.hasNext()) next[agent] = cycles.next() else next -= agent
    }

    /** Returns the current beliefs of [agent] in Jason's notation, without rules and without beliefs that Jason hides. */
    fun beliefs(agent: String): List<String> = shownBeliefs(agents.getValue(agent).ts.ag.bb)

    private fun found(difference: Difference) {
        differing += difference
        if (!difference.isOfResult) stopped += difference.agent
    }

    override fun close() {
        agents.values.forEach { it.close() }
        programs.close()
    }
}
