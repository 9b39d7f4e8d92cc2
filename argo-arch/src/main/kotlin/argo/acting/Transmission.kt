package argo.acting

import argo.calls.Failure

/**
 * A command that a link has accepted. Callbacks are attached after the write, so they do not delay the first byte.
 *
 * @property giveUp ends the command early, if this is still possible; does not wait; null if the command cannot be ended early
 */
internal class Transmission(
    val giveUp: (() -> Unit)? = null,
    private val following: (left: () -> Unit, outcome: (Failure?, String?) -> Unit) -> Unit,
) {
    /**
     * Sets the callbacks for the command's end. Call this function once, on the thread that has sent the command.
     *
     * If the time limit ends before the command begins to go out, the command is never sent, and fails with `act_timeout`. If the command
     * has begun to go out by then, it fails with `act_unconfirmed`. A replaced command fails with `act_replaced`.
     *
     * @param left called once, by any thread, before [outcome], when the command has reached the board or can no longer reach it
     * @param outcome called once, by any thread. The failure is null if the last byte has left the line or, in version 2, the board has
     * acted. The answer is the text of the board's answer; null if the options request no answer, or if there is none
     */
    fun follow(left: () -> Unit, outcome: (failure: Failure?, answer: String?) -> Unit) = following(left, outcome)
}

/** Returns a command that has already ended, with [failure] or without one, and with the text of [answer]. */
internal fun ended(failure: Failure?, answer: String? = null) = Transmission { left, outcome ->
    left()
    outcome(failure, answer)
}
