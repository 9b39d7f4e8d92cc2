package argo.fleet

import argo.fleet.cluster.Cluster
import argo.fleet.cluster.ClusterListener
import argo.fleet.cluster.ClusterView
import argo.fleet.cluster.Computer
import argo.fleet.node.FleetMessage
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit

/** The cluster of the computer [here]. A test plays the other computers. */
internal class FakeCluster(override val here: String) : Cluster {
    /** A message that this computer has sent to [to]. The test completes [end]. */
    class Sent(val to: String, val message: FleetMessage, val end: CompletableFuture<Void>)

    private lateinit var listener: ClusterListener
    private val sent = LinkedBlockingQueue<Sent>()

    /** Handles messages that the test does not await. By default, they arrive. */
    var answer: (Sent) -> Unit = { it.end.complete(null) }

    override fun listen(listener: ClusterListener) {
        this.listener = listener
        view()
    }

    override fun send(to: String, message: ByteArray): CompletionStage<Void> {
        val one = Sent(to, FleetMessage.decode(message), CompletableFuture())
        if (one.message is argo.fleet.node.Say || one.message is argo.fleet.node.Kill) sent += one else answer(one)
        return one.end
    }

    /** The other computers in touch are now [others], pairs of name and session. */
    fun view(vararg others: Pair<String, String>) {
        val computers = (others.toList() + (here to "1")).associate { (name, session) -> name to Computer(name, session) }
        listener.changed(ClusterView(computers, hasMajority = true))
    }

    fun receives(from: String, message: FleetMessage) = receives(from, message.encode())

    fun receives(from: String, message: ByteArray) = listener.message(from, message)

    fun next(): Sent = sent.poll(PATIENCE_S, TimeUnit.SECONDS) ?: throw AssertionError("nothing has been sent")

    override fun close() = Unit

    private companion object {
        const val PATIENCE_S = 60L
    }
}
