package argo.acting

import argo.calls.Failure

/**
 * A command that has been given to a link.
 *
 * What has to be known of it for its end is said behind that, so that nothing stands between the agent's decision and the bytes.
 */
internal fun interface Transmission {
    /**
     * Sets who is called at its end; called once, by the thread that has sent the command. With a time limit the outcome is known when that
     * is over: `act_timeout` if the command has not begun to go out, and then it never will; `act_unconfirmed` if it has, but is not known
     * to have been carried out. One whose place a later command has taken fails with `act_replaced`.
     *
     * @param left is called once, by any thread, when the command is no longer under way to the board; before [outcome]
     * @param outcome is called once, by any thread, with null when the command's last byte has left the line or, in version 2, the board
     *     has acted, else with the reason why not
     */
    fun follow(left: () -> Unit, outcome: (Failure?) -> Unit)
}
