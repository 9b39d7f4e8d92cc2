package argo.tools.why

import argo.recording.Place
import argo.recording.why.Answer
import argo.recording.why.BeginningCause
import argo.recording.why.Cause
import argo.recording.why.Condition
import argo.recording.why.Frame
import argo.recording.why.Had
import argo.recording.why.MessageCause
import argo.recording.why.Missed
import argo.recording.why.NotAnswer
import argo.recording.why.OrderCause
import argo.recording.why.PerceptCause
import argo.recording.why.PlanCause
import argo.recording.why.ReflexCause
import argo.recording.why.Sender
import argo.recording.why.SentCause
import argo.recording.why.StepCause
import argo.recording.why.UnchosenPlan
import argo.recording.why.UnknownCause
import argo.recording.why.Verdict
import argo.tools.command.counted

internal class WhyText {
    private val lines = ArrayList<String>()

    fun of(answer: Answer): List<String> {
        val command = answer.command
        val to = command.port?.let { " to $it" }.orEmpty()
        lines += "${at(command.seconds)}  ${sender(answer)} ${command.text}$to"
        val cause = answer.cause ?: answer.reflex
        cause?.let { explain(it, 1) }
        if (cause == null) line(1, unseen(command.by))
        answer.sent.forEach(::sent)
        answer.frame?.let { line(1, "that frame was ${ms(command.seconds - it.seconds)} old when the command was sent") }
        answer.had.forEach { lines += had(it, command.text) }
        return lines
    }

    /** Describes how a message was sent. The time is that of `replay` for the sender's recording. */
    private fun sent(sending: SentCause) {
        val took = sending.delayMs?.let { ", %.1f ms before it was taken".format(it) }.orEmpty()
        val clock = sending.clock?.let { "; compared with the first recording, its clock is $it" }.orEmpty()
        lines += "${at(sending.seconds)} of ${sending.file}  agent ${sending.agent} sent it$took$clock"
        sending.cause?.let { explain(it, 1) }
        sending.trouble?.let { line(1, "why is not known: $it") }
    }

    private fun sender(answer: Answer): String {
        val agent = answer.command.agent
        return when {
            answer.reflex?.isByBoard == true -> "the board of agent $agent carried out"
            answer.reflex != null -> "the computer of agent $agent sent, before the agent reasoned,"
            else -> "agent $agent sent"
        }
    }

    private fun unseen(by: Sender) = when (by) {
        Sender.PLAN -> "by a step of a plan that the replay did not see: a plan may have split its intention"
        Sender.REFLEX -> "as the reflex of a critical rule"
        Sender.OUTSIDE -> "because a person or another program wanted it, as by the live view; no plan did"
    }

    fun of(answer: NotAnswer): List<String> {
        lines += "agent ${answer.agent} did not send ${answer.command} up to ${at(answer.seconds)} because of its plans:"
        if (answer.plans.isEmpty()) line(1, "none has a step that sends it")
        answer.plans.forEach { unchosen(it, 1) }
        return lines
    }

    private fun explain(cause: Cause, depth: Int) {
        when (cause) {
            is StepCause -> {
                val place = place(cause.plan.place, cause.line)
                line(depth, "because of the step ${cause.step}, $place, carried out at ${at(cause.seconds)}")
                cause.tests.forEach { condition(it, "the plan had tested", depth + 1) }
                explain(cause.plan, depth)
            }
            is PlanCause -> plan(cause, depth)
            is ReflexCause -> reflex(cause, depth)
            is PerceptCause -> percept(cause, depth)
            is MessageCause -> line(
                depth, "because agent ${cause.sender} had sent ${cause.performative} ${cause.content}, taken at ${at(cause.seconds)}",
            )
            is OrderCause -> {
                val what = when (cause.kind) {
                    "believe" -> "a person set ${cause.text}"
                    "begin" -> "a person began ${cause.text}"
                    "resume", "begin_anew" -> "the agent went on from its last run"
                    else -> "a person ordered: ${cause.kind} ${cause.text}".trim()
                }
                line(depth, "because $what at ${at(cause.seconds)}")
            }
            is BeginningCause -> {
                val place = cause.line?.let { " (${cause.file}:$it)" }.orEmpty()
                line(depth, "because the program begins with ${cause.text}$place; no percept began it")
            }
            is UnknownCause -> line(depth, "because of ${cause.text}: ${cause.why}")
        }
    }

    private fun plan(plan: PlanCause, depth: Int) {
        val again = if (plan.again > 0) ", which had called itself ${counted(plan.again, "time")}" else ""
        line(depth, "of the plan ${place(plan.place)}, chosen for ${plan.trigger} at ${at(plan.seconds)}$again")
        plan.conditions.forEach { condition(it, "its context:", depth + 1) }
        explain(plan.event, depth)
    }

    private fun reflex(cause: ReflexCause, depth: Int) {
        line(depth, "as the reflex of the critical rule on ${cause.rule}; no plan did")
        cause.failure?.let { line(depth, "it was not carried out: $it") }
        cause.percept?.let { percept(it, depth) } ?: line(depth, "because of a frame that the agent did not perceive")
    }

    private fun condition(condition: Condition, what: String, depth: Int) {
        val value = if (condition.value == condition.text) "" else ", which was ${condition.value}"
        line(depth, "$what ${condition.text}$value${if (condition.holds) "" else "; not true"}")
        condition.causes.forEach { explain(it, depth + 1) }
    }

    private fun percept(cause: PerceptCause, depth: Int) {
        val frame = cause.frame
        val what = if (cause.isGone) "was perceived no more" else "was perceived"
        line(depth, "because ${cause.belief} $what from ${at(cause.seconds)} on")
        if (frame != null) {
            cause.filter?.let { line(depth, "let through: $it") }
            line(depth, frame(frame))
        } else {
            val own = "it is a belief of ARGO about a port or a reflex"
            line(depth, if (cause.from == "argo") own else "no frame in the recording has it: it is of the environment")
        }
    }

    private fun frame(frame: Frame) =
        "frame ${frame.number} of ${frame.port}, whose last byte came at ${at(frame.seconds)}: " + frame.texts.joinToString("") { "$it;" }

    private fun had(had: Had, command: String): String {
        val instead = had.commands.ifEmpty { listOf("nothing") }.joinToString()
        val place = had.replaced?.let { " in place of $it" }.orEmpty()
        val outcome = if (had.isSent) "it would have sent $command all the same" else "it would not have sent $command, but $instead"
        val filter = if (had.isDropped) ", which the filter drops," else ""
        return "had the board sent ${had.percept}$place$filter from ${at(had.from)} on, $outcome"
    }

    private fun unchosen(plan: UnchosenPlan, depth: Int) {
        line(depth, "plan ${place(plan.place)}, ${plan.trigger}${plan.context?.let { " : $it" }.orEmpty()}, with ${plan.step}")
        plan.event?.let { line(depth + 1, "its last event was $it at ${at(plan.seconds ?: 0.0)}") }
        line(depth + 1, verdict(plan))
        plan.conditions.forEach { condition(it, "its context:", depth + 1) }
        plan.missed.forEach { missed(it, depth + 1) }
        plan.cause?.let { explain(it, depth + 1) }
        plan.above.forEach { unchosen(it, depth + 1) }
    }

    private fun verdict(plan: UnchosenPlan): String {
        val chosen = plan.chosen?.let { "; chosen was the plan ${place(it.place)}" }.orEmpty()
        return when (plan.verdict) {
            Verdict.NO_EVENT -> "no event came for it"
            Verdict.NOT_APPLICABLE -> "it was not applicable$chosen"
            Verdict.NOT_CHOSEN -> "it was applicable, but not chosen$chosen"
            Verdict.NOT_REACHED -> "it was chosen, but did not come to that step: it waits, has failed or was dropped"
            Verdict.ISSUED -> "it sent the command at that time, and had no event since"
        }
    }

    private fun missed(missed: Missed, depth: Int) =
        line(depth, "the filter dropped ${missed.text}${missed.rule?.let { " ($it)" }.orEmpty()} of ${frame(missed.frame)}")

    private fun place(place: Place, line: Int? = place.line) =
        listOfNotNull(place.label?.let { "@$it" }, "${place.file}:$line").joinToString(" ")

    private fun line(depth: Int, text: String) {
        lines += "  ".repeat(depth) + text
    }

    private fun at(seconds: Double) = "%.3f s".format(seconds)

    private fun ms(seconds: Double) = "%.0f ms".format(seconds * 1000)
}
