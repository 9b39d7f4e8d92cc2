package argo.acting

import argo.calls.Failure

/**
 * A command that has been given to a link.
 *
 * The completion callback is attached after the write, so bookkeeping does not delay the first byte.
 *
 * @property giveUp ends it early, as far as that can be; null: the board cannot be stopped. Does not wait
 */
internal class Transmission(
    val giveUp: (() -> Unit)? = null,
    private val following: (left: () -> Unit, outcome: (Failure?, String?) -> Unit) -> Unit,
) {
    /**
     * Sets the callbacks for the command's end. Call this once, on the thread that has sent the command. At its time limit a command fails
     * with `act_timeout` if it has not begun to go out: it never will. If it has begun, it fails with `act_unconfirmed`. A replaced command
     * fails with `act_replaced`.
     *
     * @param left is called once, by any thread, when the command is no longer under way to the board; before [outcome]
     * @param outcome is called once, by any thread, with null when the command's last byte has left the line or, in version 2, the board
     *     has acted, else with the reason of the failure; and with the text of the board's answer if one was asked for
     */
    fun follow(left: () -> Unit, outcome: (failure: Failure?, answer: String?) -> Unit) = following(left, outcome)
}

/** Returns a command that has ended: with [failure], or null. */
internal fun ended(failure: Failure?) = Transmission { left, outcome ->
    left()
    outcome(failure, null)
}
