package argo.pausing

import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import argo.insides.Insides
import argo.observing.SourceLine
import argo.observing.StopAt
import argo.observing.StopAt.Way
import argo.observing.placeOf
import argo.platform.Plans
import argo.platform.isSameFile
import jason.asSemantics.IntendedMeans
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import java.util.Collections
import java.util.IdentityHashMap

/** The reason why an agent must pause, see [argo.observing.PauseState]. */
internal data class Met(val why: String, val place: SourceLine? = null, val intention: Int? = null)

/** A condition that pauses an agent when it is met. Only for the agent's thread. */
internal fun interface Stop {
    /**
     * Returns why the agent of [ts] must pause now; null if the condition is not met. The first call may be made before the agent
     * continues.
     *
     * @param chosen the plan chosen since the last call, or null
     */
    fun met(ts: TransitionSystem, chosen: Plan?): Met?
}

/**
 * Pauses an agent before a step at one of [lines], and before the first step of a plan with its trigger at one of [lines]. If several steps
 * in a row are on one line, pauses only before the first. Considers only the intention that Jason carries out next. If several intentions
 * are at breakpoints, the agent is paused for one after the other.
 */
internal class Breakpoints : Stop {
    /** Any thread may set [lines]. */
    @Volatile
    var lines: List<SourceLine> = emptyList()

    private var places = IdentityHashMap<IntendedMeans, SourceLine?>() // the lines of the steps that were next at the last call

    override fun met(ts: TransitionSystem, chosen: Plan?): Met? {
        val running = running(ts)
        val next = running.firstOrNull() ?: return null
        val (means, plan) = next.peek().let { it to it.plan }
        val step = placeOf(means.currentStep, plan)
        val isNew = means !in places
        val before = places.put(means, step)
        places.keys.retainAll(running.flatMapTo(Collections.newSetFromMap(IdentityHashMap())) { it })
        val trigger = placeOf(plan).takeIf { isNew && means.currentStep === plan.body }
        val place = listOf(trigger, step).find { it != null && it != before && isAt(it) } ?: return null
        return Met("breakpoint", place, next.id)
    }

    private fun isAt(place: SourceLine) = lines.any { it.line == place.line && isSameFile(it.file, place.file) }
}

/**
 * Returns the condition [stop] for the agent of [ts]. Any thread may call this function.
 *
 * @throws IllegalArgumentException if [stop] cannot be read, or names a plan that the agent does not have
 */
internal fun stopOf(stop: StopAt, ts: TransitionSystem): Stop = when (stop) {
    StopAt.NextCycle -> Stop { _, _ -> Met("one cycle is over") }
    is StopAt.ChosenPlan -> choiceOf(stop.plan, ts)
    is StopAt.Belief -> NewBelief(stop.pattern)
    is StopAt.Step -> NextStep(stop)
}

private fun choiceOf(text: String?, ts: TransitionSystem): Stop {
    if (text == null) return Stop { now, plan -> plan?.let { chosen(it, now) } }
    require(Plans.of(ts.ag).copy().any { isCalled(it, text) }) {
        "the agent has no plan $text; name one by its label, or by its trigger without arguments, as in +!drive"
    }
    return Stop { now, plan -> plan?.takeIf { isCalled(it, text) }?.let { chosen(it, now) } }
}

private fun isCalled(plan: Plan, text: String) =
    text == plan.label?.functor || text == plan.trigger.run { "$operator$type${literal.functor}" }

private fun chosen(plan: Plan, ts: TransitionSystem): Met {
    val intention = running(ts).lastOrNull { it.peek().plan === plan }
    return Met("the plan ${plan.label?.functor} for ${plan.trigger} was chosen", placeOf(plan), intention?.id)
}

/** Pauses an agent when it has a new belief that unifies with a pattern. New means that the agent did not have it at the first call. */
private class NewBelief(text: String) : Stop {
    private val pattern: Literal = try {
        PerceptReader.read(text)
    } catch (wrong: PerceptSyntaxException) {
        throw IllegalArgumentException(wrong.message, wrong)
    }
    private var before: Set<Literal>? = null

    override fun met(ts: TransitionSystem, chosen: Plan?): Met? {
        val candidates = ts.ag.bb.getCandidateBeliefs(pattern, Unifier())?.asSequence().orEmpty()
        val now = candidates.filter { !it.isRule && Unifier().unifies(pattern, it) }.toList()
        val known = before ?: now.toSet().also { before = it }
        return now.find { it !in known }?.let { Met("it believes $it") }
    }
}

/** Pauses an agent before the next step of one intention. The first call notes the step that is next at that time. */
private class NextStep(private val wanted: StopAt.Step) : Stop {
    private class From(val depth: Int, val means: IntendedMeans, val step: PlanBody?)

    private var from: From? = null

    override fun met(ts: TransitionSystem, chosen: Plan?): Met? {
        val intention = all(ts).find { it.id == wanted.intention } ?: return Met("the intention has ended")
        val means = intention.peek()
        val from = from ?: From(intention.size(), means, means.currentStep).also { from = it }
        val isNext = means !== from.means || means.currentStep !== from.step
        if (!isNext || intention !in running(ts) || !isWanted(intention.size(), from.depth)) return null
        return Met("step", means.currentStep?.let { placeOf(it, means.plan) }, wanted.intention)
    }

    private fun isWanted(depth: Int, before: Int) = when (wanted.way) {
        Way.INTO -> true
        Way.OVER -> depth <= before
        Way.OUT -> depth < before
    }
}

/** Returns the intentions of the agent of [ts] that wait for their next step, the atomic one first. */
private fun running(ts: TransitionSystem): List<Intention> =
    (listOfNotNull(Insides.atomicIntention[ts.c]) + ts.c.runningIntentions).filterNot { it.isFinished || it.peek().isFinished }

/** Returns all intentions of the agent of [ts], running and suspended ones. */
private fun all(ts: TransitionSystem): List<Intention> =
    ts.c.allIntentions.asSequence().filterNot { it.isFinished }.distinctBy { it.id }.toList()
