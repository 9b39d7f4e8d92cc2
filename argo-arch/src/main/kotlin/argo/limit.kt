package argo

import argo.calls.ArgumentException
import argo.calls.whole
import argo.calls.wholeNumber

/**
 * The internal action `argo.limit(Ms)`: the sensing interval in ms, a whole number from 0 (as fast as the line allows).
 * Until it is called the interval is 50 ms.
 *
 * Fails the plan with `error(wrong_arguments)` or `error(not_argo)`.
 */
@Suppress("ClassName")
open class limit : BoardAction("argo.limit", 1..1) {
    override fun run(call: Call) {
        val interval = wholeNumber(call.args[0])?.takeIf { it >= 0 }
            ?: throw ArgumentException("the sensing interval is a whole number of ms from 0 to ${Int.MAX_VALUE}, not ${call.args[0]}")
        call.arch.io.senseEvery(interval)
    }
}
