package argo.fleet.trial

import argo.fleet.cluster.Cluster
import argo.fleet.cluster.ClusterListener
import argo.fleet.cluster.ClusterView
import java.util.concurrent.atomic.AtomicLong

/**
 * Joins a cluster, sends and takes messages, and notes each message. A message contains its session, its number and filling bytes.
 *
 * @param session this run of the program, such as `scout1#2`
 * @param note takes each event before anything else happens. Several threads call it
 */
class Notes(private val cluster: Cluster, private val session: String, private val note: (Event) -> Unit) : ClusterListener {
    private val sent = AtomicLong()
    private val ended = AtomicLong()

    /** The number of messages without an end. */
    val underWay: Long get() = sent.get() - ended.get()

    @Volatile
    var computers: Set<String> = emptySet()
        private set

    init {
        cluster.listen(this)
    }

    /** Sends a message of [length] bytes, or a longer one if its head needs more. Not safe for use by several threads at once. */
    fun send(to: String, length: Int) {
        val number = sent.incrementAndGet()
        note(Kind.SENT, to, "$number")
        cluster.send(to, "$session $number ".padEnd(length, '.').toByteArray()).whenComplete { _, failure ->
            note(if (failure == null) Kind.TAKEN else Kind.FAILED, "$number")
            ended.incrementAndGet()
        }
    }

    /** Notes that all messages have ended. */
    fun finish() = note(Kind.FINISHED)

    override fun message(from: String, message: ByteArray) {
        val (session, number) = String(message).split(' ')
        note(Kind.TOOK, session, number)
    }

    override fun changed(view: ClusterView) {
        computers = view.computers.keys
        note(Kind.VIEWED, view.computers.keys.sorted().joinToString(",") { it })
    }

    override fun refused(reason: String) = error("$session was refused: $reason")

    private fun note(kind: Kind, vararg about: String) = note(Event(System.nanoTime(), session, kind, about.toList()))
}
