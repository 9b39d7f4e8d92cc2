package argo.fleet.cluster

import java.util.concurrent.CompletionStage

/**
 * The computers of a fleet that are in touch now, and messages among them. Each message arrives once, or its sender learns of the failure.
 * Messages of one sender arrive in the order of its calls of [send]. Computers find each other by themselves, even after a loss.
 */
interface Cluster : AutoCloseable {
    /** This computer's name. */
    val here: String

    /**
     * Joins the fleet. The listener first gets a view with at least this computer. One thread of the cluster calls the listener and
     * completes the results of [send], in order.
     *
     * @throws IllegalStateException at a second call
     */
    fun listen(listener: ClusterListener)

    /**
     * Sends [message] to the listener of the computer [to], which may be this one. Do not change [message] afterwards. Returns at once,
     * whatever the network does.
     *
     * @return completes when the listener there has returned. Fails with [Unreachable] if the computer is not in touch, or is lost before
     * it acknowledges the message. A message to a lost computer may have arrived. Fails with [Overloaded] if [message] is too long or if
     * too much waits for the computer. Fails with [Refused] if the listener threw an exception
     */
    fun send(to: String, message: ByteArray): CompletionStage<Void>

    /** Leaves the fleet. Unfinished messages fail with [Unreachable]. */
    override fun close()
}

/**
 * A computer of a fleet.
 *
 * @property session identifies one run of the computer's program
 */
data class Computer(val name: String, val session: String)

/**
 * The computers in touch.
 *
 * @property computers the computers in touch, by name
 * @property hasMajority true if more than half of [ClusterSettings.hosts] are in touch, and false without named hosts
 */
class ClusterView(val computers: Map<String, Computer>, val hasMajority: Boolean)

/** A [Cluster] calls these functions. */
interface ClusterListener {
    /**
     * A computer of the last view has sent [message]. The next message waits until this function returns. If this function throws a
     * [Refused], the sender gets it. For any other exception, the sender gets a [Refused] with the error `refused`.
     */
    fun message(from: String, message: ByteArray)

    /** The computers in touch have changed to [view]. Messages of a computer are delivered only while the last view contains it. */
    fun changed(view: ClusterView)

    /** This computer cannot stay in the fleet, and its cluster closes. [reason] is for the user. */
    fun refused(reason: String)
}

/** The arrival of a message is not confirmed. The receiver is not in touch, or was lost before the acknowledgement. */
class Unreachable(message: String) : Exception(message)

/** A message was not sent, because it is too long or because too much waits for the receiving computer. */
class Overloaded(message: String) : Exception(message)

/**
 * A message arrived, but its receiver refused it.
 *
 * @property error the reason in one word, for plans
 */
class Refused(val error: String, message: String) : Exception(message) {
    /** The refusal in the form for the sender. */
    internal val line: String get() = "$error $message"

    internal companion object {
        private const val OTHER = "refused"
        private val LINE = Regex("([a-z][a-z_]{0,40}) (.*)", RegexOption.DOT_MATCHES_ALL)

        fun of(failure: Throwable) = failure as? Refused ?: Refused(OTHER, failure.message ?: "$failure")

        /** Reads a refusal in the form of [line]. */
        fun of(line: String): Refused {
            val (error, reason) = LINE.matchEntire(line)?.destructured ?: return Refused(OTHER, line)
            return Refused(error, reason)
        }
    }
}
