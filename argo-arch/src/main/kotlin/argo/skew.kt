package argo

import argo.calls.Failure
import jason.asSyntax.ASSyntax
import jason.asSyntax.NumberTerm

/**
 * The internal action `argo.skew(Ms)`: unifies Ms with the time in ms between the oldest and the newest believed reading of the boards.
 * With one board, Ms is 0. A board does not count if it is off, is stale, or has not answered in time. Contexts of plans may contain the
 * action: `+!go : argo.skew(Ms) & Ms < 20`.
 *
 * If no board's readings are believed, the action is false in a context. As a step of a plan, the action then fails the plan with
 * `error(not_perceived)`. Fails the plan also with `error(wrong_arguments)` or `error(not_argo)`.
 */
@Suppress("ClassName")
open class skew : BoardQuery("argo.skew", 1) {
    override fun answer(call: Call): Any {
        val skew = call.args.single()
        if (!skew.isVar && skew !is NumberTerm) throw call.wrong("a skew is a number of milliseconds, not $skew")
        val skewMs = call.arch.perception.skewMs() ?: return call.unanswered {
            Failure("not_perceived", "no readings of a board are believed now")
        }
        return call.un.unifies(skew, ASSyntax.createNumber(skewMs.toDouble()))
    }
}
