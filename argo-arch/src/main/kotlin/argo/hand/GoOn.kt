package argo.hand

import argo.filters.jason.PerceptReader
import argo.mind.beginAnew
import argo.mind.replaceMind
import argo.observing.Order
import argo.observing.Outcome
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Literal

/** Goes on with the beliefs of an earlier run, see [Order.Resume]. */
internal fun TransitionSystem.resume(beliefs: List<String>): Outcome {
    val (new, known) = beliefs.partition { it.startsWith("+") }
    val told = ArrayList<String>()
    replaceMind(this, known.map(::read), told::add)
    new.forEach { ag.addBel(read(it.drop(1))) }
    return Outcome(null, told)
}

/** Begins again what an earlier run had begun, see [Order.BeginAnew]. */
internal fun TransitionSystem.beginAnew(events: List<String>): Outcome {
    val (fitting, others) = events.partition { !it.startsWith("!") || hasPlan(read(it.drop(1))) }
    fitting.forEach { beginAnew(this, it, read(it.drop(1))) }
    return Outcome(null, others.map { "$it is not begun anew: the agent has no plan for it" })
}

private fun read(text: String): Literal = PerceptReader.read(text).capply(Unifier()) as Literal // Jason solves its sums
