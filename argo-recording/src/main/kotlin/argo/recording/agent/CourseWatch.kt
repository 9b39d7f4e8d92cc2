package argo.recording.agent

import argo.recording.Mail
import argo.recording.Place
import jason.asSemantics.Intention
import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Plan
import jason.asSyntax.SourceInfo
import jason.asSyntax.Term
import java.util.IdentityHashMap
import java.util.WeakHashMap

/** Observes the course of each cycle of the agent of [ts]. Belongs to the agent's thread. */
internal class CourseWatch(private val ts: TransitionSystem) {
    private val numbers = WeakHashMap<Intention, Int>()

    /** The number of intentions counted so far. */
    var intentions = 0
        private set

    private val places = IdentityHashMap<Plan, Place>()
    private var selected: Intention? = null
    private var mail = ArrayList<Mail>()
    private val prints = PrintWatch(ts)

    /** The step that the agent carries out in the present cycle; null: none yet. */
    var step: StepNote? = null
        private set

    /** Returns the number of [intention]; null: the agent has carried out no step of it. */
    fun numberOf(intention: Intention): Int? = numbers[intention]

    /** Continues after [intentions] counted intentions; the remaining ones have these [numbers]. */
    fun restore(intentions: Int, numbers: Map<Intention, Int>) {
        this.intentions = intentions
        this.numbers.putAll(numbers)
    }

    /** Begins to observe a cycle. */
    fun begin() {
        selected = ts.c.selectedIntention
        step = null
        prints.begin()
    }

    /** Checks whether Jason has chosen an intention. */
    fun ruleApplied() {
        val now = ts.c.selectedIntention
        if (now === selected) return
        selected = now
        if (now != null && !now.isFinished) step = stepOf(now)
    }

    /** Notes that the agent has sent [message]. */
    fun sent(message: Mail) {
        mail += message
    }

    /** Ends the observation of the cycle, and returns its course. */
    fun end(): CourseNote {
        val event = ts.c.selectedEvent
        val sent = if (mail.isEmpty()) emptyList() else mail.also { mail = ArrayList() }
        val plan = if (event == null) null else ts.c.selectedOption?.plan?.let(::placeOf)
        return CourseNote(event?.triggerNow(), plan, step, ts.c.action?.termNow(), sent, prints.take(), ts.ag.bb.size())
    }

    /** True if lines that plans printed may be missing, as Java is ending. */
    val missesPrints: Boolean get() = prints.isClosed

    /** Ends all observation. */
    fun close() = prints.close()

    private fun stepOf(intention: Intention): StepNote {
        val means = intention.peek()
        val body = means.currentStep?.takeUnless { it.isEmptyBody }
        return StepNote(numbers.getOrPut(intention) { ++intentions }, intention.size(), placeOf(means.plan), body)
    }

    /** Returns the place of [plan] in the program. */
    fun placeOf(plan: Plan): Place {
        if (places.size >= MAX_CACHED) places.clear()
        return places.getOrPut(plan) {
            val source: SourceInfo? = plan.trigger.literal.srcInfo ?: plan.srcInfo
            Place(plan.label?.functor, source?.srcFile?.let(::fileName), source?.srcLine)
        }
    }

    private companion object {
        /** The largest number of cached places: a program may make plans while it runs. */
        const val MAX_CACHED = 10_000
    }
}

/** Returns the name of the file at [path], which Jason writes as a URL or as the system does: `file:robot.asl` if it is relative. */
internal fun fileName(path: String) = path.removePrefix("file:").substringAfterLast('/').substringAfterLast('\\')

/** Returns [message] in the form of a recording. */
internal fun mailOf(message: Message, failure: String? = null) = Mail(
    message.ilForce, message.sender, message.receiver,
    contentText(message.propCont), message.msgId, message.inReplyTo, failure,
)
