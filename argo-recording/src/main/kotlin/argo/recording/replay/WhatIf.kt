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
 * Runs one agent of [recording] with another program on what was recorded, without boards, threads and clocks, and notes the commands that
 * it sends. What its boards and other agents said comes at the recorded times. What it asks for is answered thus:
 *
 * - a command ends as the one of the same text did that was recorded nearest, within a second; another one succeeds in the usual time;
 * - settings, as of `argo.port`, give what they gave; others of `argo.` succeed. `argo.age` and other questions give what they gave to the
 *   same question nearest in time, within a second; otherwise they are false;
 * - chance and clocks give what they gave, in the order of asking, and beyond that something else;
 * - a timer ends when a recorded one ended at about its time, else at its time;
 * - the project's own internal actions are carried out if [program] is given; otherwise they give what they gave.
 *
 * As long as the agent does what was recorded, step by step, all of it is exactly as recorded. It has cycles of its own where the recorded
 * one slept.
 *
 * Where the beginning of the recording is missing it begins at a key frame, see [Recording.start]: with the beliefs of then, also where
 * [program] has other ones at the start, and with the intentions of then, which go on by the plans that they began with.
 *
 * Close it at the end. For one thread; at a time there can be one replay in a program.
 *
 * @param agent the agent's name
 * @param program its program; null: the recorded one
 * @param senses what it perceives
 * @param cycles its recorded cycles, from [Recording.start] on
 * @param usualNs how long a command takes that was not recorded, in ns; null: as those that were
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
    private val answers = WhatIfAnswers(RecordedCalls(cycles), isCarryingOut = program != null, usualNs)
    private val inputs = ReplayedInputs(answers, senses)
    private val files = ProgramFiles(recording)
    private val includes = RecordedIncludes(recording, agent, program?.toAbsolutePath())
    private val ts: TransitionSystem = create(program)
    private val before = ArrayList<SentCommand>()
    private var number = 0

    /** The commands that were recorded, as far as it has been run. */
    val commands: List<SentCommand> get() = before

    /** The commands that the agent has sent now. */
    val commandsNow: List<SentCommand> get() = answers.sent

    /** When the first recorded cycle of any agent began, in ns of the agents' clock, from which times count; null: none has been run. */
    var firstNs: Long? = null
        private set

    /** When the last recorded cycle began that has been run, in ns of the agent's clock. */
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

    /** With the beliefs that were recorded, and what was under way, of the plans of then. */
    private fun beginChanged(ts: TransitionSystem, start: KeyFrame) {
        val before = jasonAgent(recorded, files.of(recorded.name), RecordedIncludes(recording, recorded.name), inputs, isCarryingOut = true)
        inputs.begin(ts, start, before)
        before.ag.stopAg()
    }

    /**
     * Runs all recorded cycles, and returns itself. Once.
     * @throws RecordingException if some are missing; the commands before are there then
     */
    fun run(): WhatIf = apply {
        runRecorded()
        if (!answers.isAsRecorded) runBetween(endNs + AFTER_NS)
    }

    /**
     * As [run], but ends in the last recorded cycle, where no more time passes: with what the agent has to do there. Returns the commands,
     * to boards and to the environment, that it sends from [fromNs] on.
     */
    internal fun commandsFrom(fromNs: Long): List<String> {
        runRecorded()
        var left = MOST_AT_END
        while (left-- > 0 && (!ts.canSleep() || (answers.nextDueNs ?: Long.MAX_VALUE) <= endNs)) runOwn(endNs)
        return (answers.sent + answers.acted).filter { it.ns >= fromNs }.sortedBy { it.ns }.map { it.text }
    }

    private fun runRecorded() {
        var last: Cycle? = null
        firstNs = recording.firstNs
        for (cycle in cycles) {
            recording.requireNext(recorded.name, cycle, last?.index ?: recording.start(recorded.name)?.index ?: 0)
            if (last != null && !answers.isAsRecorded && cycle.isWoken) runBetween(cycle.ns)
            val sent = cycle.sent()
            if (cycle.isEnding && sent.isEmpty()) break // the agent might have gone on
            before += sent
            run(cycle)
            last = cycle
            endNs = cycle.ns
        }
    }

    /** Where the recorded agent slept, until [ns]: the cycles for what the agent has to do, and for what ends meanwhile. */
    private fun runBetween(ns: Long) {
        while (true) {
            val nowNs = inputs.cycle.ns
            val at = if (!ts.canSleep()) nowNs + CYCLE_NS else answers.nextDueNs ?: return
            if (at >= ns) return
            runOwn(maxOf(at, nowNs))
        }
    }

    /** A cycle that was not recorded. */
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
     * The first command that differs from the recording; null: none does.
     *
     * @param within how much earlier or later the same command may be
     */
    fun difference(within: Duration): CommandDifference? = CommandDifference.first(commands, commandsNow, within, endNs)

    /** What the agent believes now, without its rules and what Jason hides itself, as Jason writes it. */
    val beliefs: List<String> get() = shownBeliefs(ts.ag.bb)

    override fun close() {
        inputs.course.close()
        ts.end()
        files.close()
    }

    private companion object {
        /** How long a cycle takes that was not recorded, in ns. */
        const val CYCLE_NS = 1_000_000L

        /** How long an agent runs on behind the recording, since it may be slower than the recorded one, in ns. */
        const val AFTER_NS = 1_000_000_000L

        /** How many cycles it has in the last recorded one. */
        const val MOST_AT_END = 500
    }
}

/** True if something entered the agent that may have woken it. */
private val Cycle.isWoken: Boolean get() = input.run { percepts != null || mail.isNotEmpty() || ends.isNotEmpty() || events.isNotEmpty() }
