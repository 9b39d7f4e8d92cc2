package argo.orders

import argo.filters.jason.PerceptReader
import argo.mind.beginAnew
import argo.mind.replaceMind
import argo.observing.Order
import argo.observing.Outcome
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Literal

/** Carries out an [Order.Resume] with these [beliefs]. */
internal fun TransitionSystem.resume(beliefs: List<String>): Outcome {
    val (new, known) = beliefs.partition { it.startsWith("+") }
    val told = ArrayList<String>()
    replaceMind(this, known.map(::read), told::add)
    new.forEach { ag.addBel(read(it.drop(1))) }
    return Outcome(null, told)
}

/** Carries out an [Order.BeginAnew] with these [events]. */
internal fun TransitionSystem.beginAnew(events: List<String>): Outcome {
    val (fitting, others) = events.partition { !it.startsWith("!") || hasPlan(read(it.drop(1))) }
    fitting.forEach { beginAnew(this, it, read(it.drop(1))) }
    return Outcome(null, others.map { "$it is not begun anew: the agent has no plan for it" })
}

private fun read(text: String): Literal = PerceptReader.read(text).capply(Unifier()) as Literal // computes sums in it
