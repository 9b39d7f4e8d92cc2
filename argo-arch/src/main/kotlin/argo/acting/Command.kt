package argo.acting

import argo.calls.Failure

/**
 * A command for a board, from the call to its outcome. What has changed in it is read and written under the lock of its [Commands].
 *
 * @property text what is sent
 * @property deadlineNanos until when its outcome must be known, by the clock of its [Commands]; null: there is no such time
 * @property outcome takes, once, null or the reason why the command has not been carried out as far as is known
 */
internal class Command(val text: String, val urgent: Boolean, val deadlineNanos: Long?, val outcome: (Failure?) -> Unit) {
    /** How far a command has got. */
    enum class State {
        /** None of it has been sent. */
        WAITING,

        /** It has begun to go out. */
        SENDING,

        /** Its outcome is known. */
        OVER,
    }

    var state = State.WAITING

    /** How much time is left at [nowNanos], in ns; null: it has no limit. */
    fun leftNanos(nowNanos: Long): Long? = deadlineNanos?.let { it - nowNanos }

    fun isLate(nowNanos: Long): Boolean = leftNanos(nowNanos)?.let { it <= 0 } ?: false
}
