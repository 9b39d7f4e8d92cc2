package argo.acting

import argo.calls.Failure

/** A command that a link has taken. The callbacks are attached after the write, so bookkeeping does not delay the first byte. */
internal fun interface Transmission {
    /**
     * Sets the callbacks for the command's end. Call this once, on the thread that has sent the command. A command that has not begun to go
     * out at its time limit fails with `act_timeout`, and never goes out. One that has begun by then fails with `act_unconfirmed`. A
     * replaced command fails with `act_replaced`.
     *
     * @param left called once, by any thread, when the command is no longer under way to the board; before [outcome]
     * @param outcome called once, by any thread. Null: the last byte has left the line or, in version 2, the board has acted. Else: the
     *     reason of the failure
     */
    fun follow(left: () -> Unit, outcome: (Failure?) -> Unit)
}

/** Returns a command that has ended: with [failure], or null. */
internal fun ended(failure: Failure?) = Transmission { left, outcome ->
    left()
    outcome(failure)
}
