package argo

import argo.calls.ArgumentException
import argo.calls.wholeNumber

/**
 * The internal action `argo.limit(Ms)`: the sensing interval in ms, a whole number from 0 (as fast as the line allows). The default is 50
 * ms. The call sets the interval of all boards; `argo.limit(Ms, [port(P)])` sets only that of the board on P.
 *
 * Fails the plan with `error(wrong_arguments)`, `error(unknown_board)` if the agent perceives no board on P, or `error(not_argo)`.
 */
@Suppress("ClassName")
open class limit : BoardInternalAction("argo.limit", 1..2) {
    override fun run(call: Call) {
        val interval = wholeNumber(call.args[0])?.takeIf { it >= 0 }
            ?: throw ArgumentException("the sensing interval is a whole number of ms from 0 to ${Int.MAX_VALUE}, not ${call.args[0]}")
        val board = boardIn(call)
        call.arch.boards.senseEvery(interval, board)
    }
}
