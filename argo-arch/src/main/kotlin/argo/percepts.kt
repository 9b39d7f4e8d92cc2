package argo

import argo.calls.ArgumentException

/**
 * The internal action `argo.percepts(open)` starts perceiving through the port in use. `argo.percepts(block)`, or `close`, stops
 * perceiving. When an agent starts, perceiving is blocked. While it is blocked, beliefs stay.
 *
 * Fails the plan with `error(wrong_arguments)` or `error(not_argo)`.
 */
@Suppress("ClassName")
open class percepts : BoardInternalAction("argo.percepts", 1..1) {
    override fun run(call: Call) {
        val open = when (call.args[0].toString()) {
            "open" -> true
            "block", "close" -> false
            else -> throw ArgumentException("perception is set to open, block or close, not ${call.args[0]}")
        }
        call.arch.boards.perceive(open)
    }
}
