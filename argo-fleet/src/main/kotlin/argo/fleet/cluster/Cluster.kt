package argo.fleet.cluster

import java.util.concurrent.CompletionStage

/**
 * The computers of a fleet that are in touch now, and messages among them. Each message arrives once, or its sender is told that it failed.
 * Messages of one sender arrive in the order of its calls of [send]. Computers find each other by themselves, also after a loss.
 */
interface Cluster : AutoCloseable {
    /** This computer's name. */
    val here: String

    /**
     * Joins the fleet. The listener first gets a view that contains at least this computer. One thread of the cluster makes all calls of
     * the listener, and completes the results of [send], in order.
     *
     * @throws IllegalStateException at a second call
     */
    fun listen(listener: ClusterListener)

    /**
     * Sends [message] to the listener of the computer [to], which may be this one. Do not change [message] afterwards. Returns at once,
     * whatever the network does.
     *
     * @return completed when the listener there has returned. Fails with [Unreachable] if the computer is not in touch, or is lost before
     * it acknowledges the message; in the latter case the message may have arrived. Fails with [Overloaded] if [message] is too long or too
     * much waits for the computer, and with [Refused] if its listener threw an exception.
     */
    fun send(to: String, message: ByteArray): CompletionStage<Void>

    /** Leaves the fleet: messages under way fail with [Unreachable]. */
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
 * @property computers the computers in touch, by their names
 * @property hasMajority whether more than half of [ClusterSettings.hosts] are in touch; false if no hosts are named
 */
class ClusterView(val computers: Map<String, Computer>, val hasMajority: Boolean)

/** A [Cluster] calls these functions. */
interface ClusterListener {
    /**
     * A computer of the last view has sent [message]. The next message waits until this function returns. If this function throws a
     * [Refused], the sender gets it. For any other exception, the sender gets a [Refused] with the error `refused`.
     */
    fun message(from: String, message: ByteArray)

    /**
     * The computers in touch have changed to [view]. Messages of a computer are handed over only while the last view contains that
     * computer.
     */
    fun changed(view: ClusterView)

    /** This computer cannot stay in the fleet, and its cluster closes. [reason] tells the user why. */
    fun refused(reason: String)
}

/** A message is not known to have arrived: the receiving computer is not in touch, or was lost before it acknowledged the message. */
class Unreachable(message: String) : Exception(message)

/** A message was not sent: it is too long, or too much already waits for the receiving computer. */
class Overloaded(message: String) : Exception(message)

/**
 * A message arrived, but its receiver refused it.
 *
 * @property error the reason in one word, for plans
 */
class Refused(val error: String, message: String) : Exception(message) {
    /** The form in which the refusal goes to the sender. */
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
