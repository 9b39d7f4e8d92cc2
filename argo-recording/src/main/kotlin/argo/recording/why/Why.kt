package argo.recording.why

import argo.filters.matching.Explanation
import argo.recording.Cycle
import argo.recording.Mail
import argo.recording.agent.literalOf
import argo.recording.replay.AlteredPercepts
import argo.recording.replay.Difference
import argo.recording.replay.ProgramFiles
import argo.recording.replay.RecordedAnswers
import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.ReplayedAgent
import argo.recording.replay.ReplayedInputs
import argo.recording.replay.WhatIf
import jason.asSyntax.Literal

/**
 * Explains why the agents of [recording] issued a command, or did not. For an explanation, Jason runs an agent again on its recorded input,
 * and a [Trace] watches the agent.
 *
 * Close the object at the end. For one thread. A program can run one replay at a time.
 */
class Why(private val recording: Recording) : AutoCloseable {
    private val programs = ProgramFiles(recording)
    private val cycles = recording.agents.keys.associateWith { recording.cycles(it).toList() }
    private val clock = RecordingClock(recording.firstNs ?: 0)

    private val commandsOf = cycles.mapValues { (agent, cycles) -> Commands(recording, agent, cycles, clock) }

    /** All commands of the agents, in the order of their times. */
    val commands: List<RecordedCommand> = commandsOf.values.flatMap { it.all }.sortedBy { it.seconds }

    /**
     * Explains why [command] was issued. If the command is a reflex, does not search for other values of percepts.
     *
     * @param isTrying whether to search for a percept that would have kept the agent from the command if its value were different
     * @throws RecordingException if the agent cannot be replayed up to the command, or its course differs from the recorded one
     */
    fun answer(command: RecordedCommand, isTrying: Boolean = true): Answer {
        if (command.by != Sender.PLAN) return reflexAnswer(command)
        val cause = causeOf(command)
        val frame = (cause?.root() as? PerceptCause)?.frame
        val frames = (listOfNotNull(frame) + cause?.frames().orEmpty()).distinct()
        val had = if (isTrying && cause != null) Counterfactuals(cause) { percept, of -> had(command, percept, of) }.find() else emptyList()
        return Answer(command, cause, null, frame, frames, had)
    }

    /** Explains a reflex without counterfactuals. A replay does not carry out reflexes, so it cannot show the effect of another percept. */
    private fun reflexAnswer(command: RecordedCommand): Answer {
        val end = commandsOf[command.agent]?.reflex(command) ?: return Answer(command)
        val reflex = ReflexFrames(replayable(command.agent), filtersOf(command.agent), clock).cause(command, end)
        return Answer(command, null, reflex, reflex.percept?.frame, reflex.frames())
    }

    /**
     * Replays the agent with [percept] in place of the recorded percept of its kind. Percepts of a kind have equal functors, and equal
     * arguments except numbers. The replacement lasts from the frame of the recorded percept until the cycle of [command].
     *
     * @throws RecordingException like [answer], and if [percept] is no percept, or is the recorded percept itself
     */
    fun had(command: RecordedCommand, percept: String): Had {
        val literal = literal(percept)
        if (command.by != Sender.PLAN) {
            throw RecordingException("${command.text} was not sent by a plan, so a replay cannot show the effect of another percept")
        }
        val cause = causeOf(command)
        val of = cause?.percepts().orEmpty().find { isOfKind(literalOf(it.belief), literal) }
        return had(command, literal, of) ?: throw RecordingException("$percept is what the agent perceived")
    }

    /**
     * Explains why [agent] did not issue the command of [question] up to the question's time. If the question has no time, explains it up
     * to the end of the recording.
     *
     * @throws RecordingException like [answer]
     */
    fun not(agent: String, question: Question): NotAnswer {
        val cycles = cyclesOf(agent)
        val until = question.seconds?.let(clock::nanos) ?: Long.MAX_VALUE
        val last = cycles.lastOrNull { it.ns <= until } ?: throw RecordingException("agent $agent had no cycle before $question")
        requireReplayed(agent, last.index)
        val filters = filtersOf(agent)
        val unchosen = UnchosenPlans(question) { port, text -> filters.explain(port, text)?.toString() }
        val trace = replayed(agent, last.index, { unchosen.perceived(it.percepts.newestFrames) }) { inputs, answers ->
            Trace(inputs, answers, clock, filters, unchosen::taken)
        }
        return NotAnswer(agent, question.text, clock.seconds(last.ns), unchosen.plans(trace))
    }

    /**
     * Returns the step by which [agent] sent the message [id] in [cycle]; null if the replay did not see the step.
     *
     * @throws RecordingException like [answer]
     */
    internal fun sending(agent: String, cycle: Cycle, id: String): StepCause? = trace(agent, cycle.index).sent[id]

    /** Returns the recorded message of [cause], which [agent] has taken. */
    internal fun mailOf(agent: String, cause: MessageCause): Mail? = cyclesOf(agent).asSequence()
        .filter { clock.seconds(it.ns) == cause.seconds }.flatMap { it.input.mail }.find { it.id == cause.id && it.sender == cause.sender }

    internal fun nanos(seconds: Double): Long = clock.nanos(seconds)

    internal fun seconds(ns: Long): Double = clock.seconds(ns)

    private fun causeOf(command: RecordedCommand): StepCause? =
        trace(command.agent, command.index).issued.getOrNull(replayedBefore(command))?.cause

    private fun trace(agent: String, last: Long): Trace {
        requireReplayed(agent, last)
        val filters = filtersOf(agent)
        return replayed(agent, last) { inputs, answers -> Trace(inputs, answers, clock, filters) }
    }

    /**
     * Runs [agent] on its recorded input up to the cycle with the index [last], and calls [ran] after each cycle. Returns the trace that
     * [traceOf] makes.
     *
     * @throws RecordingException if the agent's course differs from the recorded one
     */
    private fun replayed(
        agent: String, last: Long, ran: (Trace) -> Unit = {}, traceOf: (ReplayedInputs, RecordedAnswers) -> Trace,
    ): Trace {
        val cycles = replayable(agent).takeWhile { it.index <= last }
        lateinit var trace: Trace
        var differing: Difference? = null
        ReplayedAgent(
            recording, recording.agents.getValue(agent), programs,
            found = { if (!it.isOfResult) differing = differing ?: it },
            boundaryOf = { inputs, answers ->
                trace = traceOf(inputs, answers)
                trace.apply { recording.start(agent)?.let(::beginAt) }
            },
        ).use { replayed ->
            for (cycle in cycles) {
                replayed.run(cycle)
                ran(trace)
                differing?.let { throw RecordingException("the replay of agent $agent differs from the recording at ${it.words}") }
            }
        }
        return trace
    }

    /** Replays the agent with [percept] in place of [of]. Returns null if [of] is [percept] itself. */
    private fun had(command: RecordedCommand, percept: Literal, of: PerceptCause?): Had? {
        val cycles = cyclesOf(command.agent)
        if (of?.belief == keyOf(percept)) return null
        val from = cycles.first { it.index == command.index || of?.isIn(it) == true }
        val before = ofPlans(command.agent).filter { it.index in from.index..command.index && it.number <= command.number }
        val isDropped = isDropped(command.agent, percept, of?.frame?.port, cycles.takeWhile { it.index < from.index })
        val percepts = AlteredPercepts(from.index, { replaced(it, percept, isDropped) })
        val inputs = replayable(command.agent).asSequence().takeWhile { it.index <= command.index }
        // recorded commands have their recorded outcomes, all others end at once
        val now = WhatIf(recording, command.agent, null, percepts, inputs, usualNs = 0).use { it.commandsFrom(from.ns) }
        val times = before.count { it.text == command.text }
        return Had(
            keyOf(percept), of?.belief, clock.seconds(from.ns), command.seconds,
            now.count { it == command.text } >= times, now, before.map { it.text }, isDropped,
        )
    }

    private fun PerceptCause.isIn(cycle: Cycle) = seconds == clock.seconds(cycle.ns)

    private fun isDropped(agent: String, percept: Literal, port: String?, before: List<Cycle>): Boolean {
        val filters = filtersOf(agent)
        before.forEach { filters.changed(it.input.filters) }
        val text = keyOf(percept.cloneNS(Literal.DefaultNS) as Literal)
        return port != null && filters.explain(port, text)?.outcome == Explanation.Outcome.DROPPED
    }

    private fun replaced(percepts: List<Literal>, by: Literal, isDropped: Boolean): List<Literal> {
        if (isDropped) return percepts.filterNot { isOfKind(it, by) }
        val found = percepts.indexOfFirst { isOfKind(it, by) }
        if (found < 0) return percepts + by
        return percepts.filterIndexed { place, it -> place == found || !isOfKind(it, by) }
            .map { if (it === percepts[found]) withAnnotsOf(it, by) else it }
    }

    private fun withAnnotsOf(one: Literal, percept: Literal): Literal =
        percept.copy().apply { if (one.hasAnnot()) one.annots.forEach { annotation -> addAnnot(annotation) } }

    private fun literal(percept: String): Literal = try {
        literalOf(percept)
    } catch (_: IllegalArgumentException) {
        throw RecordingException("$percept is no percept such as dist(front,41)")
    }

    /** Returns the filters through which [agent] perceived when its recording began, or at its key frame. */
    private fun filtersOf(agent: String) =
        RecordedFilters(recording.program).apply { changed(recording.start(agent)?.filters.orEmpty()) }

    private fun cyclesOf(agent: String) =
        cycles[agent] ?: throw RecordingException("there is no agent $agent; those that there are: ${cycles.keys.joinToString()}")

    private fun replayedBefore(command: RecordedCommand): Int {
        val start = recording.start(command.agent)?.index ?: 0
        return ofPlans(command.agent).count { it.index > start && it.number < command.number }
    }

    private fun ofPlans(agent: String) = commandsOf[agent]?.all.orEmpty().filter { it.by == Sender.PLAN }

    private fun replayable(agent: String): List<Cycle> {
        val start = recording.start(agent)?.index ?: return cyclesOf(agent)
        return cyclesOf(agent).filter { it.index > start }
    }

    /** Refuses the cycle with the index [cycle] if it comes before the key frame at which the replay of [agent] begins. */
    private fun requireReplayed(agent: String, cycle: Long) {
        val start = recording.start(agent) ?: return
        if (cycle > start.index) return
        throw RecordingException(
            "the beliefs of agent $agent at that time are not known: the beginning of its recording is missing, and it can be replayed " +
                "from %.3f s on".format(clock.seconds(start.ns)),
        )
    }

    override fun close() = programs.close()
}

/** Returns true if [one] and [other] differ only in numbers, or not at all. */
internal fun isOfKind(one: Literal, other: Literal): Boolean = one.functor == other.functor && one.arity == other.arity &&
    one.negated() == other.negated() && one.ns == other.ns &&
    (0 until one.arity).all { one.getTerm(it) == other.getTerm(it) || one.getTerm(it).isNumeric && other.getTerm(it).isNumeric }
