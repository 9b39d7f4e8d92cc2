package argo.recording.replay

import argo.filters.PerceptionFilter
import argo.recording.Cycle
import argo.recording.KeyFrame
import argo.recording.agent.restoreIn
import argo.recording.agent.shownBeliefs
import jason.asSemantics.TransitionSystem
import java.nio.file.Path
import java.time.Duration

/**
 * Runs one agent of [recording] with another program on the recorded input, without boards, threads and clocks, and notes its commands.
 * Messages of boards and other agents come at the recorded times. The agent's questions get these answers:
 *
 * - A command ends like the nearest recorded command with its text within a second. Without a recorded command, it succeeds in the usual
 *   time.
 * - Settings, such as `argo.port`, have their recorded results. Questions such as `argo.age` get their nearest recorded answer within a
 *   second. Without a recorded answer, the question is false. All other actions of `argo.` succeed.
 * - Chance and clocks give the recorded values in the order of the questions. After the last recorded value, they give other values.
 * - A timer ends together with a recorded timer of about its time. Without a recorded timer, it ends at its own time.
 * - The project's own internal actions are carried out if [program] is given. If it is null, these actions have their recorded results.
 *
 * While the agent repeats the recording step by step, all answers are exactly as recorded. The agent has additional cycles where the
 * recorded agent slept.
 *
 * If the beginning of the recording is missing, the agent begins at a key frame, see [Recording.start]. The agent then has the beliefs of
 * the key frame, even if [program] has others. The intentions of the key frame continue with their own plans.
 *
 * Close the object at the end. For one thread. A program can run one replay at a time.
 *
 * @param program the agent's program; null for the recorded program
 * @param cycles the agent's recorded cycles, from [Recording.start] on
 * @param usualNs the duration of a command that was not recorded, in ns; null for the median of the recorded durations
 * @throws RecordingException if the recording cannot be replayed, or the program cannot be read
 */
class WhatIf internal constructor(
    private val recording: Recording,
    agent: String,
    program: Path?,
    sensed: ReplayedPercepts,
    private val cycles: Sequence<Cycle>,
    usualNs: Long?,
) : AutoCloseable {
    constructor(recording: Recording, agent: String, program: Path? = null, filter: PerceptionFilter? = null) :
        this(recording, agent, program, filter?.let(::RefilteredPercepts) ?: RecordedPercepts(), recording.replayable(agent), null)

    private val recorded = recording.agents[agent]
        ?: throw RecordingException("the recording has no agent $agent; those that it has: ${recording.agents.keys.joinToString()}")
    private val answers = WhatIfAnswers(NearestRecordedCalls(cycles), isCarryingOut = program != null, usualNs)
    private val inputs = ReplayedInputs(answers, sensed)
    private val files = ProgramFiles(recording)
    private val includes = RecordedIncludes(recording, agent, program?.toAbsolutePath())
    private val ts: TransitionSystem = create(program)
    private val before = ArrayList<TimedCommand>()
    private var number = 0

    /** The recorded commands up to the agent's current cycle. */
    val commands: List<TimedCommand> get() = before

    /** The commands that the agent has sent in this run. */
    val commandsNow: List<TimedCommand> get() = answers.sent

    /** The beginning of the first recorded cycle of any agent, in ns of the agents' clock; null if there is none. Times count from here. */
    var firstNs: Long? = null
        private set

    /** The beginning of the last recorded cycle that was run, in ns of the agent's clock. */
    var endNs: Long = 0
        private set

    private fun create(program: Path?) = try {
        val start = recording.start(recorded.name)
        val source = program?.toAbsolutePath() ?: files.of(recorded.name)
        jasonAgent(recorded, source, includes, inputs).also { ts ->
            if (start == null && program == null) recorded.beginning?.restoreIn(ts)
            if (start == null || program == null) inputs.begin(ts, start) else beginChanged(ts, start)
        }
    } catch (failed: Throwable) {
        files.close()
        throw refusalOf(failed)
    }

    /** Begins another program with the beliefs and intentions of the key frame [start]. The intentions continue with the recorded plans. */
    private fun beginChanged(ts: TransitionSystem, start: KeyFrame) {
        val before = jasonAgent(recorded, files.of(recorded.name), RecordedIncludes(recording, recorded.name), inputs, isCarryingOut = true)
        inputs.begin(ts, start, before)
        before.ag.stopAg()
    }

    /**
     * Runs all recorded cycles. Returns this object. Call this function only once.
     *
     * @throws RecordingException if cycles are missing; [commands] and [commandsNow] then end at the gap
     */
    fun run(): WhatIf = apply {
        runRecorded()
        if (!answers.isAsRecorded) runBetween(endNs + AFTER_NS)
    }

    /**
     * Runs like [run], but ends in the last recorded cycle. There the agent finishes its work while no time passes. Returns the agent's
     * commands from [fromNs] on, to boards and to the environment.
     */
    internal fun commandsFrom(fromNs: Long): List<String> {
        runRecorded()
        var left = MOST_AT_END
        while (left-- > 0 && (!ts.canSleep() || (answers.nextDueNs ?: Long.MAX_VALUE) <= endNs)) runOwn(endNs)
        return (answers.sent + answers.acted).filter { it.ns >= fromNs }.sortedBy { it.ns }.map { it.text }
    }

    private fun runRecorded() {
        var last: Cycle? = null
        val begin = recording.start(recorded.name)?.index ?: 0
        firstNs = recording.firstNs
        for (cycle in cycles) {
            recording.requireNext(recorded.name, cycle, last?.index ?: begin, !includes.isOfRecordedProgram)
            if (last != null && !answers.isAsRecorded && cycle.isWoken) runBetween(cycle.ns)
            val sent = cycle.sent()
            if (cycle.isEnding && sent.isEmpty()) break // the recorded agent may have continued
            before += sent
            run(cycle)
            last = cycle
            endNs = cycle.ns
        }
    }

    /**
     * Runs additional cycles, which are not in the recording, up to [ns]. In them the agent does its work and takes the ends that are due.
     */
    private fun runBetween(ns: Long) {
        while (true) {
            val nowNs = inputs.cycle.ns
            val at = if (!ts.canSleep()) nowNs + CYCLE_NS else answers.nextDueNs ?: return
            if (at >= ns) return
            runOwn(maxOf(at, nowNs))
        }
    }

    private fun runOwn(ns: Long) = run(Cycle(WhatIfAnswers.BETWEEN, number + 1, ns))

    private fun run(cycle: Cycle): Unit = try {
        if (number > 0) ts.rest(cycle.number - number - 1)
        inputs.next(cycle)
        number = maxOf(number + 1, cycle.number)
        ts.cycle(number, recorded.isConditional, includes)
        answers.ended(inputs.end())
    } catch (broken: IllegalArgumentException) {
        throw refusalOf(broken)
    } catch (deep: StackOverflowError) {
        throw refusalOf(deep)
    }

    /**
     * Returns the first difference between the commands of this run and the recorded ones; null if there is none.
     *
     * @param within the largest difference in time between equal commands
     */
    fun difference(within: Duration): CommandDifference? = CommandDifference.first(commands, commandsNow, within, endNs)

    /** The agent's current beliefs in Jason's notation, without rules and without beliefs that Jason hides. */
    val beliefs: List<String> get() = shownBeliefs(ts.ag.bb)

    override fun close() {
        inputs.course.close()
        ts.end()
        files.close()
    }

    private companion object {
        const val CYCLE_NS = 1_000_000L

        /** How long an agent continues after the recording, in ns, since it may be slower than the recorded agent. */
        const val AFTER_NS = 1_000_000_000L

        /** The largest number of additional cycles at the time of the last recorded cycle. */
        const val MOST_AT_END = 500
    }
}

/** True if an input of the cycle may have woken the agent. */
private val Cycle.isWoken: Boolean get() = input.run { percepts != null || mail.isNotEmpty() || ends.isNotEmpty() || events.isNotEmpty() }
