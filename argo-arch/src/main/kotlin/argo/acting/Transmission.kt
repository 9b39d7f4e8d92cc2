package argo.acting

import argo.calls.Failure

/**
 * A command that a link has accepted. Callbacks are attached only after the write, so they do not delay the first byte.
 *
 * @property giveUp ends the command early, if it still can; does not wait; null: the board cannot be stopped
 */
internal class Transmission(
    val giveUp: (() -> Unit)? = null,
    private val following: (left: () -> Unit, outcome: (Failure?, String?) -> Unit) -> Unit,
) {
    /**
     * Sets the callbacks for the command's end. Call this once, on the thread that has sent the command. If the time limit is over before
     * the command begins to go out, the command fails with `act_timeout` and is never sent. If the command has begun to go out by then, it
     * fails with `act_unconfirmed`. A replaced command fails with `act_replaced`.
     *
     * @param left called once, by any thread, before [outcome]: when the command has reached the board, or never will
     * @param outcome called once, by any thread. The failure is null if the last byte has left the line or, in version 2, the board has
     *     acted. The answer is the text of the board's answer; null: the options asked for none, or there is none
     */
    fun follow(left: () -> Unit, outcome: (failure: Failure?, answer: String?) -> Unit) = following(left, outcome)
}

/** Returns a command that has ended with [failure], or without one, and with the text of the requested [answer]. */
internal fun ended(failure: Failure?, answer: String? = null) = Transmission { left, outcome ->
    left()
    outcome(failure, answer)
}
