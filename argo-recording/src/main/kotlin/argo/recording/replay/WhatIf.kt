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
 * Runs one agent of [recording] with another program on the recorded input, without boards, threads and clocks, and notes the commands that
 * it sends. The messages of boards and other agents come at the recorded times. The agent's questions get these answers:
 *
 * - a command ends like the nearest recorded one of the same text within a second; if there is none, it succeeds in the usual time;
 * - settings, such as `argo.port`, have their recorded results; other actions of `argo.` succeed. `argo.age` and other questions get the
 *   answer to the same question nearest in time, within a second; otherwise they are false;
 * - chance and clocks give the recorded values in the order of the questions, and after the last one other values;
 * - a timer ends together with a recorded one that ended at about its time, else at its time;
 * - the project's own internal actions are carried out if [program] is given; otherwise they have their recorded results.
 *
 * As long as the agent repeats the recording step by step, all answers are exactly as recorded. It has cycles of its own where the recorded
 * agent slept.
 *
 * If the beginning of the recording is missing, the agent begins at a key frame, see [Recording.start]: with the beliefs of the key frame,
 * even if [program] begins with others, and with the intentions of the key frame, which go on by the plans with which they began.
 *
 * Close it at the end. For one thread; at a time there can be one replay in a program.
 *
 * @param agent the agent's name
 * @param program the agent's program; null: the recorded program
 * @param senses the agent's percepts
 * @param cycles the agent's recorded cycles, from [Recording.start] on
 * @param usualNs the time of a command that was not recorded, in ns; null: the median of the recorded ones
 * @throws RecordingException if the recording cannot be replayed, or the program cannot be read
 */
class WhatIf internal constructor(
    private val recording: Recording,
    agent: String,
    program: Path?,
    senses: Senses,
    private val cycles: Sequence<Cycle>,
    usualNs: Long?,
) : AutoCloseable {
    constructor(recording: Recording, agent: String, program: Path? = null, filter: PerceptionFilter? = null) :
        this(recording, agent, program, filter?.let(::FilteredSenses) ?: RecordedSenses(), recording.replayable(agent), null)

    private val recorded = recording.agents[agent]
        ?: throw RecordingException("the recording has no agent $agent; those that it has: ${recording.agents.keys.joinToString()}")
    private val answers = WhatIfAnswers(NearestRecordedCalls(cycles), isCarryingOut = program != null, usualNs)
    private val inputs = ReplayedInputs(answers, senses)
    private val files = ProgramFiles(recording)
    private val includes = RecordedIncludes(recording, agent, program?.toAbsolutePath())
    private val ts: TransitionSystem = create(program)
    private val before = ArrayList<SentCommand>()
    private var number = 0

    /** The recorded commands, as far as the agent has run. */
    val commands: List<SentCommand> get() = before

    /** The commands that the agent has sent in this run. */
    val commandsNow: List<SentCommand> get() = answers.sent

    /**
     * The beginning of the first recorded cycle of any agent, from which times count, in ns of the agents' clock; null: none has been run.
     */
    var firstNs: Long? = null
        private set

    /** The beginning of the recorded cycle that was run last, in ns of the agent's clock. */
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

    /** Begins another program at the key frame [start], with its beliefs and intentions; these go on by the recorded plans. */
    private fun beginChanged(ts: TransitionSystem, start: KeyFrame) {
        val before = jasonAgent(recorded, files.of(recorded.name), RecordedIncludes(recording, recorded.name), inputs, isCarryingOut = true)
        inputs.begin(ts, start, before)
        before.ag.stopAg()
    }

    /**
     * Runs all recorded cycles, and returns itself. Call it only once.
     * @throws RecordingException if cycles are missing; [commands] and [commandsNow] then have those up to there
     */
    fun run(): WhatIf = apply {
        runRecorded()
        if (!answers.isAsRecorded) runBetween(endNs + AFTER_NS)
    }

    /**
     * Runs like [run], but ends in the last recorded cycle: the agent finishes its work there while no more time passes. Returns the
     * commands, to boards and to the environment, that it sends from [fromNs] on.
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
            if (cycle.isEnding && sent.isEmpty()) break // the recorded agent might have gone on
            before += sent
            run(cycle)
            last = cycle
            endNs = cycle.ns
        }
    }

    /** Runs cycles of the agent's own until [ns], while the recorded agent slept: to do its work, and to take in the ends that are due. */
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
     * Returns the first difference between the commands and the recorded ones; null: there is none.
     *
     * @param within the time by which the same command may come earlier or later
     */
    fun difference(within: Duration): CommandDifference? = CommandDifference.first(commands, commandsNow, within, endNs)

    /** The beliefs of the agent now as Jason writes them, without rules and beliefs that Jason itself hides. */
    val beliefs: List<String> get() = shownBeliefs(ts.ag.bb)

    override fun close() {
        inputs.course.close()
        ts.end()
        files.close()
    }

    private companion object {
        const val CYCLE_NS = 1_000_000L

        /** The time for which an agent runs on after the recording, since it may be slower than the recorded one, in ns. */
        const val AFTER_NS = 1_000_000_000L

        /** The largest number of own cycles in the last recorded cycle. */
        const val MOST_AT_END = 500
    }
}

/** True if something entered the agent that may have woken it. */
private val Cycle.isWoken: Boolean get() = input.run { percepts != null || mail.isNotEmpty() || ends.isNotEmpty() || events.isNotEmpty() }
