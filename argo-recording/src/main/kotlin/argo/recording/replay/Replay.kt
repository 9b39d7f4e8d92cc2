package argo.recording.replay

import argo.recording.Cycle
import argo.recording.agent.shownBeliefs

/**
 * Runs the agents of [recording] again, by Jason itself, on what was recorded: cycle by cycle, in the order of their times, without boards,
 * threads and clocks. After each cycle it compares what came of it. An agent that does something else than it did is not run on, since what
 * was recorded after that is no answer to what it does now.
 *
 * A replay changes nothing outside of it: of the project's own internal actions and functions what was recorded is used, and they are not
 * carried out, unless [isChecking]: then each is, and where it gives another result that is a difference too, and the recorded one is used.
 * An architecture of the project's in the place of `argo.Arch` is refused, unless [isChecking].
 *
 * An agent whose beginning is missing begins at its first key frame, see [Recording.start]: each for itself, since the messages that came
 * to it afterwards are recorded with it, whenever they were sent.
 *
 * Close it at the end. For one thread; at a time there can be one replay in a program.
 *
 * @param isChecking whether the project's own code is carried out again
 * @throws RecordingException if the recording cannot be replayed
 */
class Replay(private val recording: Recording, private val isChecking: Boolean = false) : AutoCloseable {
    private val programs = ProgramFiles(recording)
    private val agents = create()
    private val cycles = agents.keys.associateWith { recording.replayable(it).iterator() }
    private val next = HashMap<String, Cycle>()
    private val stopped = HashSet<String>()
    private val differing = ArrayList<Difference>()
    private var underWay = ""

    /** What differs from the recording so far, in the order of the cycles. */
    val differences: List<Difference> get() = differing

    /** How many cycles have been run. */
    var cyclesRun = 0L
        private set

    /** When the cycle began that was run last, in ns of the agents' clock; null: none was run. */
    var lastNs: Long? = null
        private set

    init {
        cycles.keys.forEach(::read)
    }

    /** When the next cycle began, in ns of the agents' clock; null: none is left. */
    val nextNs: Long? get() = next.values.minOfOrNull { it.ns }

    /** Runs all cycles that began before [untilNs], and returns itself. */
    fun run(untilNs: Long = Long.MAX_VALUE): Replay = apply {
        while (true) {
            val (agent, cycle) = next.minByOrNull { (_, cycle) -> cycle.ns } ?: break
            if (cycle.ns >= untilNs) break
            runCycle(agent, cycle)
        }
    }

    private fun create() = try {
        recording.agents.values.associate { it.name to ReplayedAgent(recording, it, programs, ::found, isChecking) }
    } catch (failed: Throwable) {
        programs.close()
        throw refusalOf(failed)
    }

    private fun runCycle(agent: String, cycle: Cycle) {
        underWay = agent
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

    /** What [agent] believes now, without its rules and what Jason hides itself, as Jason writes it. */
    fun beliefs(agent: String): List<String> = shownBeliefs(agents.getValue(agent).ts.ag.bb)

    private fun found(cycle: Cycle, what: String, recorded: String?, now: String?, cause: String) {
        differing += Difference(underWay, cycle.number, cycle.ns, what, recorded, now, cause)
        if (!differing.last().isOfResult) stopped += underWay
    }

    override fun close() {
        agents.values.forEach { it.close() }
        programs.close()
    }
}
