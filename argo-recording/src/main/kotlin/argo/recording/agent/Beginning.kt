package argo.recording.agent

import argo.recording.Beginning
import jason.asSemantics.Event
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal
import jason.bb.DefaultBeliefBase

/** What the agent of [ts], whose program has just been read, believes and has to do. */
internal fun beginningOf(ts: TransitionSystem) =
    Beginning(ts.ag.bb.filterNot { it.isRule }.map(::literalText), ts.c.events.map { triggerText(it.trigger) })

/**
 * Gives the agent of [ts], whose program has just been read again, what it believed and had to do then: where the program draws a number
 * or reads a clock these differ. What has as many beliefs or events only is the same program.
 */
internal fun Beginning.restoreIn(ts: TransitionSystem) {
    val now = beginningOf(ts)
    if (now.beliefs != beliefs && now.beliefs.size == beliefs.size && ts.ag.bb is DefaultBeliefBase) believe(ts, now.beliefs)
    if (now.events != events && now.events.size == events.size) intend(ts, now.events)
}

private fun Beginning.believe(ts: TransitionSystem, now: List<String>) {
    val places = beliefs.indices.iterator()
    val all = ts.ag.bb.map { belief ->
        if (belief.isRule) return@map belief
        val place = places.next()
        if (beliefs[place] == now[place]) belief else literalOf(beliefs[place]).placedAs(belief)
    }
    ts.ag.bb.clear()
    all.forEach { ts.ag.bb.add(1, it) }
}

private fun Beginning.intend(ts: TransitionSystem, now: List<String>) {
    val all = ts.c.events.mapIndexed { place, event ->
        if (events[place] == now[place]) return@mapIndexed event
        val trigger = triggerOf(events[place])
        trigger.literal = trigger.literal.placedAs(event.trigger.literal)
        Event(trigger, event.intention)
    }
    ts.c.events.clear()
    ts.c.events.addAll(all)
}

private fun Literal.placedAs(other: Literal) = also { it.srcInfo = other.srcInfo }
