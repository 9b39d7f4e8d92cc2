package argo.recording.agent

import argo.recording.Course
import argo.recording.Mail
import argo.recording.Place
import argo.recording.Step
import jason.asSemantics.ActionExec
import jason.asSemantics.Event
import jason.asSyntax.PlanBody
import jason.asSyntax.Trigger

/** The course of a cycle, whose texts are not made yet. Immutable. */
internal class CourseNote(
    private val event: (() -> String)?,
    private val plan: Place?,
    private val step: StepNote?,
    private val action: (() -> String)?,
    private val mail: List<Mail>,
    private val printed: List<String>,
    private val beliefs: Int,
) {
    /** The name of the first message that the agent sent; null: it sent none. */
    val firstMessage: String? get() = mail.firstOrNull()?.id

    /** True if the agent chose an event or carried out a step. */
    val hasHappened: Boolean get() = event != null || step != null

    /** Makes the texts, on any thread. */
    fun course() = Course(event?.invoke(), plan, step?.step(), action?.invoke(), mail, printed, beliefs)
}

/** A [Step] whose text need not be made yet; a null [body] means that the plan had ended. */
internal class StepNote(private val intention: Int, private val depth: Int, private val plan: Place, body: PlanBody?) {
    private val line: Int? = body?.srcInfo?.srcLine
    private val text = body?.run { laterText(listOf(bodyTerm)) { "$bodyType$bodyTerm" } }

    /** Makes the texts, on any thread. */
    fun step() = Step(intention, depth, plan, line, text?.invoke())
}

/**
 * Returns the text of the trigger of this event as it is now: the literal of a belief is the belief itself, which may get other
 * annotations.
 */
internal fun Event.triggerNow(): () -> String {
    val now = trigger.run { Trigger(operator, type, literal.copy()) }
    return laterText(listOf(now.literal)) { "$now" }
}

/** Returns the text of this action as it is now: the environment, which gets the action, may change it. */
internal fun ActionExec.termNow(): () -> String {
    val now = actionTerm.copy()
    return laterText(listOf(now)) { "$now" }
}
