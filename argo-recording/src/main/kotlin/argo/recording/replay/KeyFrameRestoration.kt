package argo.recording.replay

import argo.insides.Insides
import argo.platform.Plans
import argo.recording.KeyFrame
import argo.recording.agent.Counters
import argo.recording.agent.CourseWatch
import argo.recording.agent.Keeper
import argo.recording.agent.MAX_MIND_BYTES
import argo.recording.agent.Mind
import argo.recording.agent.ProgramParts
import argo.recording.agent.WatchedCode
import argo.recording.agent.literalOf
import argo.recording.agent.make
import argo.recording.agent.mindOf
import jason.JasonException
import jason.asSemantics.CircumstanceListener
import jason.asSemantics.Option
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.Rule
import jason.bb.DefaultBeliefBase
import jason.util.RunnableSerializable
import java.io.ByteArrayInputStream
import java.io.IOException
import java.util.Base64
import java.util.concurrent.Callable
import java.util.concurrent.ScheduledFuture
import java.util.zip.InflaterInputStream

/**
 * Restores the agent of [ts] to its state at [frame]. Jason has just made the agent, which has had no cycle yet.
 *
 * @param program the parts of the recorded program; the agent's intentions consist of this program's plans
 * @param isProgram whether the agent has the recorded program; if false, the agent keeps its own rules and plans
 */
internal class KeyFrameRestoration(
    private val frame: KeyFrame,
    private val ts: TransitionSystem,
    private val program: ProgramParts,
    private val code: WatchedCode,
    private val course: CourseWatch,
    private val isProgram: Boolean = true,
) {
    /**
     * Restores the agent. Returns the running timers by their numbers.
     *
     * @throws RecordingException if the key frame is damaged, or belongs to another program or version of Jason
     */
    fun restore(): Map<Int, Callable<*>> {
        if (frame.parts != program.size) refuse("the program has ${program.size} plans and steps, and had ${frame.parts}")
        val counters = Counters.read()
        try {
            val packed = ByteArrayInputStream(Base64.getDecoder().decode(frame.mind))
            val mind = InflaterInputStream(packed).use { it.readNBytes(MAX_MIND_BYTES + 1) }
            if (mind.size > MAX_MIND_BYTES) refuse("it holds more than $MAX_MIND_BYTES bytes")
            return mindOf(mind, program, code).also(::believe).let(::intend)
        } catch (refused: RecordingException) {
            throw refused
        } catch (broken: Exception) {
            refuse(unreadable(broken) ?: throw broken)
        } catch (other: LinkageError) {
            refuse("$other")
        } catch (_: StackOverflowError) {
            refuse("its objects are nested too deeply")
        } finally {
            Counters.write(counters)
        }
    }

    /** Returns the fault of the key frame that [broken] reveals, in words; null if the fault is in ARGO. */
    private fun unreadable(broken: Exception): String? = when (broken) {
        is IOException, is IllegalArgumentException, is IndexOutOfBoundsException, is JasonException -> "${broken.message}"
        is ReflectiveOperationException -> "$broken"
        else -> null
    }

    private fun refuse(why: String): Nothing =
        throw RecordingException(
            "the key frame at cycle ${frame.number} cannot be read: it is damaged, or of another version of Jason ($why)",
        )

    private fun believe(mind: Mind) {
        val bb = ts.ag.bb as DefaultBeliefBase
        val own = ts.ag.bb.filter { it.isRule }
        bb.clear()
        if (!isProgram) own.forEach { bb.add(1, it) }
        val believed = frame.beliefs.mapIndexed { place, text -> ruleAt(place, mind) ?: literalOf(text) }
        believed.forEach { if (isProgram || !it.isRule) bb.add(1, it) }
        Insides.percepts[bb] = ordered(frame.percepts.map { bb.contains(believed[it]) ?: refuse("a percept is missing") })
    }

    /** Returns the rule at this [place] among the beliefs; null if there is none. */
    private fun ruleAt(place: Int, mind: Mind): Rule? = frame.rules[place]?.let(program.rules::get) ?: mind.rules?.get(place)

    /** Returns a set of [percepts] with the order of the list, if one is found. The order depends on the capacity of the set. */
    private fun ordered(percepts: List<Literal>): HashSet<Literal> {
        val enough = generateSequence(SMALLEST) { it * 2 }.first { it * LOAD >= frame.mostPercepts }
        val sizes = listOf(enough) + generateSequence(SMALLEST) { it * 2 }.takeWhile { it <= LARGEST && it <= enough * SMALLEST }
        val sets = sizes.asSequence().map { size -> HashSet<Literal>(size).apply { addAll(percepts) } }
        return sets.firstOrNull { set -> set.asSequence().zip(percepts.asSequence()).all { (one, other) -> one === other } } ?: sets.first()
    }

    private fun intend(mind: Mind): Map<Int, Callable<*>> {
        if (isProgram && mind.plans != null) Plans.of(ts.ag).replaceBy(mind.plans)
        val c = ts.c
        val others = c.listeners.toList()
        val timers = HashMap<Int, Callable<*>>()
        val waits = mind.waits.map { wait -> begun({ wait.timer?.let { number -> timers[number] = it } }) { wait.make(ts) } }
        c.listeners.clear()
        c.listeners.addAll(others + waits.filterIndexed { place, _ -> mind.waits[place].isListening })
        c.create()
        c.events += mind.events
        c.runningIntentions += mind.running
        c.pendingIntentions += mind.pending
        c.pendingEvents += mind.pendingEvents
        Insides.atomicEvent[c] = mind.atomicEvent
        Insides.atomicIntention[c] = mind.atomic
        Insides.isAtomicSuspended[c] = mind.isAtomicSuspended
        Insides.goalConditions[c] = mind.goalConditions
        Insides.selectedEvent[c] = mind.event
        Insides.selectedOption[c] = mind.plan?.let { Option(it, Unifier()) }
        Insides.selectedIntention[c] = mind.intention
        Insides.cyclesUnperceived[ts] = frame.cyclesUnperceived
        Insides.isAsleep[ts] = frame.isAsleep
        course.restore(frame.intentions, mind.numbered.zip(mind.numbers).toMap())
        return timers
    }

    /** Returns the listener that [make] makes. The listener begins at most one timer, and [timer] gets the work of this timer. */
    private fun begun(timer: (Callable<*>) -> Unit, make: () -> CircumstanceListener): CircumstanceListener {
        val keeper = object : Keeper {
            override fun <V> timer(work: Callable<V>, delayNs: Long, schedule: (Callable<V>) -> ScheduledFuture<V>): ScheduledFuture<V> {
                timer(work)
                return Unscheduled(work)
            }

            override fun left(work: RunnableSerializable) = Unit
        }
        return Keeper.within(keeper, make)
    }

    private companion object {
        /** The capacities of Java's sets are powers of two. A set is at most three quarters full. */
        const val SMALLEST = 16
        const val LARGEST = 1 shl 20
        const val LOAD = 0.75
    }
}
