package argo.view.timeline

import argo.recording.Call
import argo.recording.CommandEnd
import argo.recording.Cycle
import argo.recording.GivenOrder
import argo.recording.Mail
import argo.recording.PerceivedSnapshot
import argo.recording.Sent
import argo.recording.Step

/**
 * Makes the items of one agent from its cycles, in order, and links each item with its recorded causes.
 *
 * @param agent the index of the agent in the timeline
 * @param zeroNs the beginning of the timeline, in ns of the agent's clock
 * @param items the list of all agents' items, to which the items are added
 * @param outcomes the outcomes of the agent's commands, by their numbers
 */
internal class AgentItems(
    private val agent: Int,
    private val zeroNs: Long,
    private val items: MutableList<Item>,
    private val outcomes: Map<Long, CommandEnd>,
) {
    private val plans = PlanLinks()
    private val beliefSteps = HashMap<String, Int>()
    private val stepsOfCalls = HashMap<Int, Int>()
    private var lastPercepts: Int? = null
    private val perceptsOf = HashMap<String, Int>()
    private var lastMail = HashMap<String, Int>()

    /** The steps that sent messages, by the messages' names. */
    val sent = HashMap<String, Int>()

    /** The items of received messages, each with its message. */
    val taken = ArrayList<Pair<Int, Mail>>()

    fun add(cycle: Cycle) {
        cycle.input.orders.forEach { ordered(cycle, it) }
        perceive(cycle)
        cycle.input.mail.forEach { mail ->
            val text = "${mail.performative} of ${mail.sender ?: "nobody"}: ${mail.content}"
            mail.sender?.let { sender ->
                val id = add(cycle.ns, Lane.EVENTS, text, listOf("a message that came in"))
                lastMail[sender] = id
                taken += id to mail
            }
        }
        cycle.input.ends.forEach { end -> if (end.failure != null) stepsOfCalls[end.number]?.let { plans.failed = it } }
        cycle.course.event?.let { chosen(cycle, it) }
        val step = cycle.course.step?.let { stepped(cycle, it) }
        if (step != null) cycle.course.mail.forEach { sent[it.id] = step }
        cycle.input.calls.forEach { called(cycle, it, step) }
        cycle.course.printed.forEach { add(cycle.ns, Lane.PRINTED, it, causes = listOfNotNull(step)) }
    }

    private fun ordered(cycle: Cycle, order: GivenOrder) {
        val files = order.files.map { it.address.substringAfterLast('/') }
        val texts = order.text.lines()
        val text = "${order.kind} ${texts.joinToString(limit = MOST_SHOWN)}${files.joinToString()}"
        val by = if (order.kind in OF_LAST_RUN) "the agent went on from its last run" else "an order of a person"
        val id = add(cycle.ns, Lane.EVENTS, text, listOf(by, "cycle ${cycle.number}"))
        for (subject in texts.map { it.trimStart('-', '+', '!') }) when (order.kind) {
            "begin", "begin_anew" -> beliefSteps[GOAL_SIGN + functor(subject)] = id
            "believe", "forget", "resume" -> beliefSteps[functor(subject)] = id
        }
    }

    private fun perceive(cycle: Cycle) {
        val frames = cycle.input.snapshots.map {
            add(it.receivedNs, Lane.LINE, it.texts.joinToString("; ", limit = MOST_SHOWN), frameDetail(it))
        }
        val change = cycle.input.percepts ?: return
        if (frames.isEmpty() && change.now.isEmpty()) return
        val text = change.now.joinToString(limit = MOST_SHOWN).ifEmpty { "no percept is new" }
        val id = add(cycle.ns, Lane.PERCEPTS, text, listOf("perceived in cycle ${cycle.number}") + change.now, causes = frames)
        lastPercepts = id
        change.now.forEach { perceptsOf[bare(it)] = id }
    }

    private fun frameDetail(it: PerceivedSnapshot): List<String> {
        val heldBack = it.heldBack
        return listOf("from ${it.port}: ${it.texts.joinToString("; ")}") +
            (if (heldBack.isEmpty()) emptyList() else listOf("held back by the filter: ${heldBack.joinToString("; ")}"))
    }

    private fun chosen(cycle: Cycle, trigger: String) {
        val posed = if (GOAL.containsMatchIn(trigger)) plans.posing(trigger) else null
        val plan = cycle.course.plan
        val cause = posed ?: causeOfBelief(trigger)
        val found = plan?.run { "plan ${label?.let { "@$it " }.orEmpty()}in ${file ?: "the program"}, line ${line ?: "?"}" }
        val detail = listOf(found ?: "no plan was chosen for it", "cycle ${cycle.number}")
        val text = trigger.removeSuffix("[source(self)]").removeSuffix("[source(percept)]")
        val id = add(cycle.ns, Lane.EVENTS, text, detail, plan == null && trigger.startsWith("-!"), listOfNotNull(cause))
        if (plan != null) plans.chosen(id, plan, posed?.let { plans.intentionOf(it) })
    }

    private fun causeOfBelief(trigger: String): Int? {
        val literal = trigger.drop(1)
        val source = SOURCE.find(trigger)?.groupValues?.get(1)
        return when {
            source == "percept" -> perceptsOf[bare(literal)].takeIf { trigger.startsWith('+') } ?: lastPercepts
            source == null || source == "self" ->
                beliefSteps[if (literal.startsWith(GOAL_SIGN)) GOAL_SIGN + functor(literal.drop(1)) else functor(literal)]
            else -> lastMail[source]
        }
    }

    private fun stepped(cycle: Cycle, step: Step): Int? {
        val text = step.text ?: return null
        val cause = plans.causeOf(step)
        val where = "intention ${step.intention}, ${step.plan.file ?: "the program"}, line ${step.line ?: step.plan.line ?: "?"}"
        val id = add(cycle.ns, Lane.INTENTIONS, text, listOf(where, "cycle ${cycle.number}"), causes = listOfNotNull(cause))
        plans.stepped(id, step, text)
        if (text.startsWith('+') || text.startsWith('-')) beliefSteps[functor(text.trimStart('+', '-', '<', '>'))] = id
        return id
    }

    private fun called(cycle: Cycle, call: Call, step: Int?) {
        if (call.failure != null && step != null) plans.failed = step
        val number = call.number
        if (number != null && step != null) stepsOfCalls[number] = step
        call.commands.forEach { command(cycle, it, step) }
    }

    private fun command(cycle: Cycle, sent: Sent, step: Int?) {
        val end = outcomes[sent.number]
        val outcome = when {
            end == null -> "its outcome is not in the recording"
            end.failure != null -> "failed after ${inMs(end.ns - cycle.ns)}: ${end.failure?.error}: ${end.failure?.message}"
            else -> "done after ${inMs(end.ns - cycle.ns)}"
        }
        val detail = listOf("to ${sent.port}", outcome, "cycle ${cycle.number}")
        val isBad = end?.failure != null
        val id = add(cycle.ns, Lane.COMMANDS, sent.text, detail, isBad, listOfNotNull(step), end?.ns, sent.number)
        if (end == null || isBad) return
        add(end.ns, Lane.LINE, "${sent.text} to ${sent.port}", listOf("the command had left, or the board had acted"), causes = listOf(id))
    }

    private fun add(
        ns: Long, lane: Lane, text: String, detail: List<String> = emptyList(), isBad: Boolean = false, causes: List<Int> = emptyList(),
        untilNs: Long? = null, command: Long? = null,
    ): Int {
        items += Item(items.size, agent, lane, seconds(ns), untilNs?.let(::seconds), text, detail, isBad, causes, command)
        return items.lastIndex
    }

    private fun seconds(ns: Long) = (ns - zeroNs) / NANOS

    private companion object {
        const val NANOS = 1e9
        const val MOST_SHOWN = 4
        const val GOAL_SIGN = "!"
        val OF_LAST_RUN = setOf("resume", "begin_anew")
        val GOAL = Regex("^[+-][!?]")
        val SOURCE = Regex("source\\(([^()]*)\\)")

        fun bare(literal: String) = literal.substringBeforeLast("[source").filterNot(Char::isWhitespace)

        fun inMs(ns: Long) = "%.1f ms".format(ns / 1e6)
    }
}

/** Returns the name at the beginning of [literal]. */
internal fun functor(literal: String) = literal.trim().takeWhile { it.isLetterOrDigit() || it in "_:.~" }
