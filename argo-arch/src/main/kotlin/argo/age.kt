package argo

import argo.calls.Failure
import jason.asSyntax.ASSyntax
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.NumberTerm

/**
 * The internal action `argo.age(Literal, Ms)`: unifies Ms with the age in ms of the percept belief that unifies with Literal. The age is
 * the time since the board's newest message with the percept. The agent may not have perceived this message yet. A percept that the board
 * repeats is young, though it causes no event. A percept that a filter freezes or holds back grows older. If several percepts match,
 * Literal is unified with the youngest. Contexts of plans may contain the action: `+!go : argo.age(dist(f,_), Ms) & Ms < 200`.
 *
 * If no believed percept of a board unifies with Literal, the action is false in a context. As a step of a plan, the action then fails the
 * plan with `error(not_perceived)`. Fails the plan also with `error(wrong_arguments)` or `error(not_argo)`.
 */
@Suppress("ClassName")
open class age : BoardQuery("argo.age", 2) {
    override fun answer(call: Call): Any {
        val (percept, age) = call.args
        if (percept !is Literal || percept.isVar || percept is ListTerm) {
            throw call.wrong("a percept is a literal such as dist(f,X), not $percept")
        }
        if (!age.isVar && age !is NumberTerm) throw call.wrong("an age is a number of milliseconds, not $age")
        val (youngest, ageMs) = call.arch.perception.youngest(call.ts.ag.bb, percept, call.un) ?: return call.unanswered {
            Failure("not_perceived", "no percept of a board that is believed now unifies with $percept")
        }
        return call.un.unifies(percept, youngest) && call.un.unifies(age, ASSyntax.createNumber(ageMs.toDouble()))
    }
}
