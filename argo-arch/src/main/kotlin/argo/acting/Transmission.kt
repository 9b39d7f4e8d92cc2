package argo.acting

import argo.calls.Failure

/**
 * A command that a link has accepted. The callbacks are attached after the write, so their cost does not delay the first byte.
 *
 * @property giveUp ends the command early, as far as possible, without waiting; null: the board cannot be stopped
 */
internal class Transmission(
    val giveUp: (() -> Unit)? = null,
    private val following: (left: () -> Unit, outcome: (Failure?, String?) -> Unit) -> Unit,
) {
    /**
     * Sets the callbacks for the command's end. Call this once, on the thread that has sent the command. A command that has not begun to go
     * out at its time limit fails with `act_timeout`, and never goes out. A command that has begun to go out fails with `act_unconfirmed`
     * at its time limit. A replaced command fails with `act_replaced`.
     *
     * @param left called once, by any thread, when the command is no longer under way to the board; before [outcome]
     * @param outcome called once, by any thread. Null: the last byte has left the line or, in version 2, the board has acted. Else: the
     *     reason of the failure. Its second argument is the text of the board's answer, if the options asked for one
     */
    fun follow(left: () -> Unit, outcome: (failure: Failure?, answer: String?) -> Unit) = following(left, outcome)
}

/** Returns a command that has ended, with [failure] or null, and with the text of the requested [answer]. */
internal fun ended(failure: Failure?, answer: String? = null) = Transmission { left, outcome ->
    left()
    outcome(failure, answer)
}
