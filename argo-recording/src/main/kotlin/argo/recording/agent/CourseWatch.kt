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

/** What comes of the cycles of the agent of [ts]. Belongs to the agent's thread. */
internal class CourseWatch(private val ts: TransitionSystem) {
    private val numbers = WeakHashMap<Intention, Int>()

    /** How many intentions have been counted. */
    var intentions = 0
        private set

    private val places = IdentityHashMap<Plan, Place>()
    private var selected: Intention? = null
    private var mail = ArrayList<Mail>()
    private val prints = PrintWatch(ts)

    /** The step that is carried out in the cycle that runs; null: none yet. */
    var step: StepNote? = null
        private set

    /** The number of [intention]; null: no step of it has been carried out. */
    fun numberOf(intention: Intention): Int? = numbers[intention]

    /** [intentions] were counted, and those that are left have these [numbers]. */
    fun restore(intentions: Int, numbers: Map<Intention, Int>) {
        this.intentions = intentions
        this.numbers.putAll(numbers)
    }

    /** A cycle begins. */
    fun begin() {
        selected = ts.c.selectedIntention
        step = null
        prints.begin()
    }

    /** Jason may have chosen an intention. */
    fun ruleApplied() {
        val now = ts.c.selectedIntention
        if (now === selected) return
        selected = now
        if (now != null && !now.isFinished) step = stepOf(now)
    }

    /** The agent has sent [message]. */
    fun sent(message: Mail) {
        mail += message
    }

    /** What came of the cycle that ends. */
    fun end(): CourseNote {
        val event = ts.c.selectedEvent
        val sent = if (mail.isEmpty()) emptyList() else mail.also { mail = ArrayList() }
        val plan = if (event == null) null else ts.c.selectedOption?.plan?.let(::placeOf)
        return CourseNote(event?.triggerNow(), plan, step, ts.c.action?.termNow(), sent, prints.take(), ts.ag.bb.size())
    }

    /** True if lines that plans printed may be missing, as Java is ending. */
    val missesPrints: Boolean get() = prints.isClosed

    /** Nothing is watched any more. */
    fun close() = prints.close()

    private fun stepOf(intention: Intention): StepNote {
        val means = intention.peek()
        val body = means.currentStep?.takeUnless { it.isEmptyBody }
        return StepNote(numbers.getOrPut(intention) { ++intentions }, intention.size(), placeOf(means.plan), body)
    }

    /** Where [plan] stands. */
    fun placeOf(plan: Plan): Place {
        if (places.size >= MAX_CACHED) places.clear()
        return places.getOrPut(plan) {
            val source: SourceInfo? = plan.trigger.literal.srcInfo ?: plan.srcInfo
            Place(plan.label?.functor, source?.srcFile?.let(::fileName), source?.srcLine)
        }
    }

    private companion object {
        /** A program may make plans while it runs. */
        const val MAX_CACHED = 10_000
    }
}

/** The name of the file at [path], which Jason writes as a URL or as the system does: `file:robot.asl` if it is relative. */
internal fun fileName(path: String) = path.removePrefix("file:").substringAfterLast('/').substringAfterLast('\\')

/** [message] as a recording has it. */
internal fun mailOf(message: Message, failure: String? = null) = Mail(
    message.ilForce, message.sender, message.receiver,
    contentText(message.propCont), message.msgId, message.inReplyTo, failure,
)
