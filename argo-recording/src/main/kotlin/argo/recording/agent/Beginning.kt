package argo.recording.agent

import argo.observing.isHidden
import argo.recording.Beginning
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal
import jason.bb.BeliefBase
import jason.bb.DefaultBeliefBase

/** Returns the beliefs and events of the agent of [ts] just after Jason has read its program. */
internal fun beginningOf(ts: TransitionSystem) =
    Beginning(ts.ag.bb.filterNot { it.isRule }.map(::literalText), ts.c.events.map { triggerText(it.trigger) })

/**
 * Gives the recorded beliefs and events to the agent of [ts]. Jason has just read the agent's program again. If the program draws a number
 * or reads a clock, the recorded beliefs and events differ from those of the new reading.
 */
internal fun Beginning.restoreIn(ts: TransitionSystem) {
    val now = beginningOf(ts)
    if (now.beliefs != beliefs && ts.ag.bb is DefaultBeliefBase) believe(ts, now.beliefs)
    if (now.events != events) intend(ts, now.events)
}

private fun Beginning.believe(ts: TransitionSystem, now: List<String>) {
    val before = ts.ag.bb.toList()
    var place = 0
    val all = before.mapNotNull { belief -> if (belief.isRule) belief else believed(place, now, belief).also { place++ } }
    ts.ag.bb.clear()
    (all + beliefs.drop(place).map(::literalOf)).forEach { ts.ag.bb.add(1, it) }
}

/**
 * Returns the belief recorded at [place]; null if there is none. [now] are the current texts, and [belief] is the current belief at
 * [place].
 */
private fun Beginning.believed(place: Int, now: List<String>, belief: Literal): Literal? = when (val text = beliefs.getOrNull(place)) {
    null -> null
    now[place] -> belief
    else -> literalOf(text).placedAs(belief)
}

private fun Beginning.intend(ts: TransitionSystem, now: List<String>) {
    val before = ts.c.events.toList()
    val all = events.mapIndexed { place, text ->
        val event = before.getOrNull(place)
        if (event != null && now[place] == text) return@mapIndexed event
        val trigger = triggerOf(text)
        if (event != null) trigger.literal = trigger.literal.placedAs(event.trigger.literal)
        Event(trigger, Intention.EmptyInt)
    }
    ts.c.events.clear()
    ts.c.events.addAll(all)
}

private fun Literal.placedAs(other: Literal) = also { it.srcInfo = other.srcInfo }

/** Returns the beliefs in [base] in Jason's notation, without rules and without beliefs that Jason hides. */
internal fun shownBeliefs(base: BeliefBase): List<String> = base.filterNot { it.isRule || it.isHidden }.map { "$it" }
