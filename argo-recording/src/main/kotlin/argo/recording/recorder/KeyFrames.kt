package argo.recording.recorder

import argo.insides.Insides
import argo.insides.WaitEvents
import argo.platform.Plans
import argo.recording.FilterChange
import argo.recording.KeyFrame
import argo.recording.agent.CourseWatch
import argo.recording.agent.MAX_MIND_BYTES
import argo.recording.agent.Mind
import argo.recording.agent.ProgramParts
import argo.recording.agent.TermWriter
import argo.recording.agent.bytesOf
import argo.recording.agent.describe
import argo.recording.agent.literalText
import jason.asSemantics.CircumstanceListener
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal
import jason.asSyntax.Rule
import jason.stdlib.suspend
import java.io.ByteArrayOutputStream
import java.io.NotSerializableException
import java.util.Base64
import java.util.IdentityHashMap
import java.util.concurrent.TimeUnit
import java.util.zip.DeflaterOutputStream

/**
 * Takes key frames of the agent of [ts] from time to time. A key frame is taken at the end of a cycle, if it can describe all current
 * activities of the agent. Make this object before the agent's first cycle. Only for the agent's thread.
 */
internal class KeyFrames(private val ts: TransitionSystem, private val course: CourseWatch) {
    private class Timer(val wait: CircumstanceListener, val dueNs: Long)

    private val program = ProgramParts(ts.ag)
    private val isKnown = WaitEvents.isThere
    private val timers = HashMap<Int, Timer>()
    private val filters = LinkedHashMap<String?, FilterChange>()
    private var mostPercepts = 0
    private var dueNs = Long.MIN_VALUE
    private var missingNs = Long.MIN_VALUE

    /** Notes that the agent has begun the timer [number], for [delayNs] from [ns] on. */
    fun timer(number: Int, ns: Long, delayNs: Long) {
        val wait = ts.c.listeners.lastOrNull() ?: return // a .wait adds its listener immediately before its timer
        if (!isKnown || !WaitEvents.isWait(wait) || timers.values.any { it.wait === wait }) return
        if (WaitEvents.timeout[wait] == TimeUnit.NANOSECONDS.toMillis(delayNs)) timers[number] = Timer(wait, ns + delayNs)
    }

    /** Notes that the agent's program has been exchanged. Later key frames contain the plans and rules that are new. */
    fun reloaded() = program.forgetMoved()

    fun ended(number: Int) {
        timers -= number
    }

    fun filterChanged(change: FilterChange) {
        if (change.port == null) filters.clear()
        filters[change.port] = change
    }

    fun perceived(count: Int) {
        mostPercepts = maxOf(mostPercepts, count)
    }

    /**
     * Returns a key frame at the end of [cycle]; null if none is due. Another thread makes the key frame's texts. If a due key frame cannot
     * be made, returns a key frame with only the reason, once in each interval.
     *
     * @param begun the number of operations that the agent has begun outside of its thread
     * @param open the numbers of the operations that have not ended
     */
    fun take(cycle: CycleNote, begun: Int, open: Set<Int>, perceived: List<Literal>): KeyFrameNote? {
        if (dueNs == Long.MIN_VALUE) dueNs = cycle.ns + INTERVAL_NS
        if (cycle.ns < dueNs) return null
        val reason = try {
            obstacle(open) ?: return taken(cycle, begun, perceived).also {
                dueNs = cycle.ns + (ts.ag.bb.size() * OF_BELIEF_NS).coerceIn(INTERVAL_NS, MAX_INTERVAL_NS)
            }
        } catch (inside: NotSerializableException) {
            inside.message ?: "a Java object"
        } catch (other: LinkageError) {
            "this version of Jason has other fields ($other)"
        } catch (_: StackOverflowError) { // Java writes each element of a list within the one before
            "a list in an intention was too long"
        } catch (other: RuntimeException) { // a thread of the project may change the agent; the agent must continue
            "the agent was being changed ($other)"
        }
        if (cycle.ns < missingNs) return null
        missingNs = cycle.ns + INTERVAL_NS
        return KeyFrameNote(KeyFrame(cycle.index, cycle.number, cycle.ns, missing = reason))
    }

    /** Returns why the agent has no key frame now. `MindSerialization` finds further reasons, such as a loop `for`. */
    private fun obstacle(open: Set<Int>): String? {
        val c = ts.c
        return when {
            c.hasMsg() -> "messages waited in its mailbox"
            c.hasPendingAction() || c.feedbackActions.isNotEmpty() -> "an action of the environment was under way"
            c.action != null -> "an action of the environment had begun"
            Insides.tasks[ts].isNotEmpty() -> "work for the next cycle waited"
            else -> waitingIntention(open) ?: (open - timers.keys).firstOrNull()?.let { "a call or timer, its number $it, was under way" }
        }
    }

    /** Describes an intention with a wait that no key frame can contain; null if there is none. */
    private fun waitingIntention(open: Set<Int>): String? {
        val waiting = ts.c.listeners.filter(WaitEvents::isWait).mapTo(HashSet()) { WaitEvents.intention[it] }
        return ts.c.pendingIntentions.entries.firstNotNullOfOrNull { (key, intention) ->
            val isKnown = intention in waiting || key.startsWith(suspend.SUSPENDED_INT) || isAsk(intention) && open.all(timers::containsKey)
            if (isKnown) null else "the intention ${described(intention)} was waiting"
        }
    }

    private fun isAsk(intention: Intention) = "${intention.suspendedReason}" == "waiting_ask"

    private fun described(intention: Intention): String {
        val means = intention.takeUnless { it.isFinished }?.peek() ?: return "${intention.id}"
        val step = means.currentStep?.bodyTerm
        val place = course.placeOf(means.plan)
        return "${means.trigger} at ${step ?: "its end"} (${place.file}:${means.currentStep?.srcInfo?.srcLine ?: place.line})"
    }

    private fun taken(cycle: CycleNote, begun: Int, perceived: List<Literal>): KeyFrameNote {
        val beliefs = ArrayList<Literal>(ts.ag.bb.size())
        val places = IdentityHashMap<Literal, Int>()
        val rules = HashMap<Int, Int>()
        val added = HashMap<Int, Rule>()
        for (belief in ts.ag.bb) {
            val place = beliefs.size
            if (belief is Rule) {
                val known = program.rules.indexOfFirst { it === belief }
                if (known == -1) added[place] = belief else rules[place] = known
                beliefs += belief
            } else {
                if (!belief.isGround) throw NotSerializableException("the belief $belief had variables")
                places[belief] = place
                beliefs += belief.copy() // the belief's annotations may change
            }
        }
        val percepts = ts.ag.bb.percepts.asSequence().mapNotNull(places::get).toList()
        val mind = bytesOf(mind(added.takeIf { it.isNotEmpty() }), program)
        if (mind.size > MAX_MIND_BYTES) throw NotSerializableException("its events and intentions took more than $MAX_MIND_BYTES bytes")
        val frame = KeyFrame(
            cycle.index, cycle.number, cycle.ns, null, emptyList(), rules, percepts, maxOf(mostPercepts, percepts.size), emptyList(),
            filters.values.toList(), begun, timers.mapValues { it.value.dueNs }, course.intentions,
            Insides.cyclesUnperceived[ts], Insides.isAsleep[ts], program.size,
        )
        return KeyFrameNote(frame, beliefs, perceived, mind)
    }

    private fun mind(added: HashMap<Int, Rule>?): Mind {
        val c = ts.c
        val listening = c.listeners.filter(WaitEvents::isWait)
        val numbers = timers.entries.associateTo(IdentityHashMap()) { (number, timer) -> timer.wait to number }
        val waits = listening.map { describe(it, numbers[it], true) } +
            timers.filterValues { timer -> listening.none { it === timer.wait } }.map { (number, timer) ->
                describe(timer.wait, number, false)
            }
        val intentions = c.allIntentions.asSequence().filter { course.numberOf(it) != null }.distinct().toList()
        return Mind(
            ArrayList(c.events), c.atomicEvent, ArrayList(c.runningIntentions), Insides.atomicIntention[c],
            Insides.isAtomicSuspended[c], LinkedHashMap(c.pendingIntentions), LinkedHashMap(c.pendingEvents),
            Insides.goalConditions[c], c.selectedEvent, c.selectedOption?.plan, c.selectedIntention, ArrayList(waits),
            ArrayList(intentions), intentions.mapTo(ArrayList()) { course.numberOf(it) ?: 0 },
            if (program.hasPlans()) null else ArrayList(Plans.of(ts.ag).all), added,
        )
    }

    private companion object {
        /** The shortest time between two key frames. */
        val INTERVAL_NS = TimeUnit.SECONDS.toNanos(5)

        /** The longest time until the next key frame is due. */
        val MAX_INTERVAL_NS = TimeUnit.SECONDS.toNanos(20)

        /** The additional time for each belief, since many beliefs take longer to write. */
        val OF_BELIEF_NS = TimeUnit.MILLISECONDS.toNanos(20)
    }
}

/** A key frame without its texts. The literals do not change. */
internal class KeyFrameNote(
    private val frame: KeyFrame,
    private val beliefs: List<Literal> = emptyList(),
    private val perceived: List<Literal> = emptyList(),
    private val mind: ByteArray = ByteArray(0),
) {
    val ns: Long get() = frame.ns

    val size: Int get() = (beliefs.size + perceived.size) * BELIEF_BYTES + mind.size

    /** False if [frame] contains only the reason why there is no key frame. */
    val isThere: Boolean get() = frame.missing == null

    fun frame(): KeyFrame {
        if (!isThere) return frame
        val (believed, percepts) = beliefs.map(::literalText) to perceived.map(::literalText)
        val refused = (believed + percepts).find(TermWriter::isRefused)
            ?: return frame.copy(beliefs = believed, perceived = percepts, mind = packed())
        return KeyFrame(frame.index, frame.number, frame.ns, missing = "a belief held ${TermWriter.refusalOf(refused)}")
    }

    private fun packed(): String {
        val bytes = ByteArrayOutputStream()
        DeflaterOutputStream(bytes).use { it.write(mind) }
        return Base64.getEncoder().encodeToString(bytes.toByteArray())
    }

    private companion object {
        const val BELIEF_BYTES = 100
    }
}
