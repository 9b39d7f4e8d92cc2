package argo

import argo.calls.ArgumentException
import argo.calls.wholeNumber

/**
 * The internal action `argo.limit(Ms)`: sets the sensing interval of all boards in ms. Ms is a whole number from 0, which means as fast as
 * the line allows. The default is 50 ms. `argo.limit(Ms, [port(P)])` sets only the interval of the board on P.
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
