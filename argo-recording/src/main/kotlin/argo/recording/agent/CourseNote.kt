package argo.recording.agent

import argo.recording.Course
import argo.recording.Mail
import argo.recording.Place
import argo.recording.Step
import jason.asSemantics.Event
import jason.asSyntax.PlanBody
import jason.asSyntax.Term
import jason.asSyntax.Trigger

/** What came of a cycle, whose texts are not made yet. Nothing of it changes. */
internal class CourseNote(
    private val event: Trigger?,
    private val plan: Place?,
    private val step: StepNote?,
    private val action: Term?,
    private val mail: List<Mail>,
    private val printed: List<String>,
    private val beliefs: Int,
) {
    /** Whether an event was chosen, or a step carried out. */
    val hasHappened: Boolean get() = event != null || step != null

    /** Any thread. */
    fun course() = Course(event?.toString(), plan, step?.step(), action?.toString(), mail, printed, beliefs)
}

/** A [Step] whose text is not made yet; [body] is null: the plan had ended. */
internal class StepNote(private val intention: Int, private val depth: Int, private val plan: Place, private val body: PlanBody?) {
    /** Any thread. */
    fun step() = Step(intention, depth, plan, body?.srcInfo?.srcLine, body?.let { "${it.bodyType}${it.bodyTerm}" })
}

/** The trigger of this event as it is now: the literal of a belief is the belief itself, which may get other annotations. */
internal fun Event.triggerNow(): Trigger = trigger.run { Trigger(operator, type, literal.copy()) }
