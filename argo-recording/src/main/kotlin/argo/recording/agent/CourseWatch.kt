package argo.recording.agent

import argo.recording.Course
import argo.recording.Mail
import argo.recording.Place
import argo.recording.Step
import jason.asSemantics.ActionExec
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.SourceInfo
import jason.asSyntax.Trigger
import java.util.IdentityHashMap
import java.util.WeakHashMap

/** Observes the course of each cycle of the agent of [ts]. Only for the agent's thread. */
internal class CourseWatch(private val ts: TransitionSystem) {
    private val numbers = WeakHashMap<Intention, Int>()

    var intentions = 0
        private set

    private val places = IdentityHashMap<Plan, Place>()
    private var selected: Intention? = null
    private var mail = ArrayList<Mail>()
    private val prints = PrintWatch(ts)

    var step: StepNote? = null
        private set

    /** Returns the number of [intention]; null if the agent has carried out no step of it. */
    fun numberOf(intention: Intention): Int? = numbers[intention]

    /** Continues to count intentions from [intentions] on. [numbers] are the numbers of the current intentions. */
    fun restore(intentions: Int, numbers: Map<Intention, Int>) {
        this.intentions = intentions
        this.numbers.putAll(numbers)
    }

    fun begin() {
        selected = ts.c.selectedIntention
        step = null
        prints.begin()
    }

    fun ruleApplied() {
        val now = ts.c.selectedIntention
        if (now === selected) return
        selected = now
        if (now != null && !now.isFinished) step = stepOf(now)
    }

    fun sent(message: Mail) {
        mail += message
    }

    fun end(): CourseNote {
        val event = ts.c.selectedEvent
        val sent = if (mail.isEmpty()) emptyList() else mail.also { mail = ArrayList() }
        val plan = if (event == null) null else ts.c.selectedOption?.plan?.let(::placeOf)
        return CourseNote(event?.triggerNow(), plan, step, ts.c.action?.termNow(), sent, prints.take(), ts.ag.bb.size())
    }

    /** True if Java is ending. Lines of plans may then be missing. */
    val missesPrints: Boolean get() = prints.isClosed

    fun close() = prints.close()

    private fun stepOf(intention: Intention): StepNote {
        val means = intention.peek()
        val body = means.currentStep?.takeUnless { it.isEmptyBody }
        return StepNote(numbers.getOrPut(intention) { ++intentions }, intention.size(), placeOf(means.plan), body)
    }

    /** Forgets the places of plans, which a reload may have changed. */
    fun forgetPlaces() = places.clear()

    fun placeOf(plan: Plan): Place {
        if (places.size >= MAX_CACHED) places.clear()
        return places.getOrPut(plan) { placeIn(plan) }
    }

    private companion object {
        /** The largest number of cached places. A program that makes plans at run time could have any number. */
        const val MAX_CACHED = 10_000
    }
}

internal fun placeIn(plan: Plan): Place {
    val source: SourceInfo? = plan.trigger.literal.srcInfo ?: plan.srcInfo
    return Place(plan.label?.functor, source?.srcFile?.let(::fileName), source?.srcLine)
}

/** Returns the name of the file at [path]. Jason writes [path] as a URL or in the system's form. A relative path is `file:robot.asl`. */
internal fun fileName(path: String) = path.removePrefix("file:").substringAfterLast('/').substringAfterLast('\\')

internal fun mailOf(message: Message) =
    Mail(message.ilForce, message.sender, message.receiver, contentText(message.propCont), message.msgId, message.inReplyTo)

/** The course of a cycle without its texts. Immutable. */
internal class CourseNote(
    private val event: (() -> String)?,
    private val plan: Place?,
    private val step: StepNote?,
    private val action: (() -> String)?,
    private val mail: List<Mail>,
    private val printed: List<String>,
    private val beliefs: Int,
) {
    val firstMessage: String? get() = mail.firstOrNull()?.id

    val hasHappened: Boolean get() = event != null || step != null

    fun course() = Course(event?.invoke(), plan, step?.step(), action?.invoke(), mail, printed, beliefs)
}

/** A [Step] without its text. If [body] is null, the plan had ended. */
internal class StepNote(private val intention: Int, private val depth: Int, private val plan: Place, body: PlanBody?) {
    private val line: Int? = body?.srcInfo?.srcLine
    private val text = body?.run { laterText(listOf(bodyTerm)) { "$bodyType$bodyTerm" } }

    fun step() = Step(intention, depth, plan, line, text?.invoke())
}

/**
 * Returns a function for the current text of this trigger. The trigger's literal may be the belief itself, and its annotations may change.
 */
internal fun Event.triggerNow(): () -> String {
    val now = trigger.run { Trigger(operator, type, literal.copy()) }
    return laterText(listOf(now.literal)) { "$now" }
}

/** Returns a function for the current text of this action. The environment gets the action and may change it. */
internal fun ActionExec.termNow(): () -> String {
    val now = actionTerm.copy()
    return laterText(listOf(now)) { "$now" }
}
