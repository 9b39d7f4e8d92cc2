package argo.fleet.cluster

import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage

/**
 * A cluster on a [group]. Each message arrives once and in order, even if the group loses, repeats or swaps frames. Callers of [send], the
 * group's threads and the loop hold the lock only briefly, and never while they call the listener.
 *
 * @param hosts the computers of the fleet; empty if they are not known
 */
internal class GroupCluster(private val group: Group, private val hosts: Set<String>, private val loop: Loop) : Cluster, GroupListener {
    /** The session with another member. The session is kept after a loss, since the member may return. */
    private inner class Peer(member: Computer) {
        val outgoing = Outgoing(member.name, nextPiece)
        val incoming = Incoming()
        var isUnanswered = false
        var hasSentNonsense = false
    }

    private val lock = Any()
    private val peers = LinkedHashMap<Computer, Peer>()
    private var members = listOf<Computer>()

    /**
     * The first piece number of a new session. The number is above all earlier numbers, so that no receiver mistakes new pieces for
     * repetitions.
     */
    private var nextPiece = 1L
    private var unanswered = 0
    private var rivalSince: Long? = null
    private var isWatching = false
    private lateinit var listener: ClusterListener

    @Volatile
    private var isClosed = false

    override val here: String get() = group.here.name

    override fun listen(listener: ClusterListener) {
        check(!this::listener.isInitialized) { "the cluster has a listener already" }
        this.listener = listener
        group.join(this)
    }

    override fun send(to: String, message: ByteArray): CompletionStage<Void> {
        val done = CompletableFuture<Void>()
        synchronized(lock) {
            val member = called(to)
            when {
                isClosed || member == null ->
                    return CompletableFuture.failedFuture(Unreachable("the computer $to is not in touch with $here"))
                member == group.here -> loop.execute { end(Outgoing.End(done, handOver(here, message))) }
                else -> try {
                    peers.getValue(member).outgoing.add(message, done)
                    transmitDue(member)
                } catch (e: Overloaded) {
                    return CompletableFuture.failedFuture(e)
                }
            }
        }
        return done
    }

    /** Returns the member with the name [name]. Of two members, returns the older, since the newer may have the name by mistake. */
    private fun called(name: String) = members.firstOrNull { it.name == name }

    private fun transmitDue(member: Computer) {
        peers.getValue(member).outgoing.due(loop.now()).forEach { group.transmit(member, it.bytes()) }
        watch()
    }

    /**
     * Schedules [tick] if a message may be lost, or if this computer may have to leave. Without these reasons, the loop's thread can sleep.
     */
    private fun watch() {
        if (isWatching || rivalSince == null && members.all { peers[it]?.outgoing?.isEmpty ?: true }) return
        isWatching = true
        loop.after(TICK_MILLIS, ::tick)
    }

    override fun arrived(from: Computer, frame: ByteArray): Unit = synchronized(lock) {
        val peer = peers[from]?.takeIf { called(from.name) == from } ?: return // no member here yet; the sender will repeat the frame
        try {
            when (val news = Frame.of(frame)) {
                is Frame.Piece -> take(from, peer, news)
                is Frame.Acknowledgement -> {
                    val ends = peer.outgoing.acknowledged(news, loop.now())
                    if (ends.isNotEmpty()) loop.execute { ends.forEach(::end) }
                    transmitDue(from)
                }
            }
        } catch (e: IllegalArgumentException) {
            if (!peer.hasSentNonsense) LOG.log(System.Logger.Level.WARNING, "computer ${from.name} sends what is left out: ${e.message}")
            peer.hasSentNonsense = true
        }
    }

    private fun take(from: Computer, peer: Peer, piece: Frame.Piece) {
        val outcome = peer.incoming.take(piece)
        outcome.answer?.let { group.transmit(from, it.bytes()) }
        outcome.message?.let { message ->
            unanswered++
            loop.execute { handOver(from, peer, message) }
        }
    }

    private fun handOver(from: Computer, peer: Peer, message: Incoming.Message) {
        val refusal = handOver(from.name, message.content)
        synchronized(lock) {
            peer.incoming.taken(message.number, refusal?.line)
            peer.isUnanswered = true
            unanswered--
            if (unanswered == 0 || message.number % ANSWER_EVERY == 0L) answerAll()
        }
    }

    /** Sends each sender one acknowledgement for all of its messages that the listener has taken. */
    private fun answerAll() = members.forEach { member ->
        val peer = peers[member]?.takeIf { it.isUnanswered } ?: return@forEach
        peer.isUnanswered = false
        group.transmit(member, peer.incoming.acknowledgement().bytes())
    }

    private fun handOver(from: String, message: ByteArray): Refused? = try {
        listener.message(from, message)
        null
    } catch (@Suppress("TooGenericExceptionCaught") e: Throwable) { // an error must not leave the sender waiting
        if (e !is Refused) LOG.log(System.Logger.Level.ERROR, "a message of $from failed", e)
        Refused.of(e)
    }

    private fun end(end: Outgoing.End) {
        if (end.failure == null) end.done.complete(null) else end.done.completeExceptionally(end.failure)
    }

    override fun viewed(members: List<Computer>): Unit = synchronized(lock) {
        if (isClosed) return
        val lost = this.members.filter { it !in members }.flatMap { giveUp(it, "the computer ${it.name} was lost before it acknowledged") }
        this.members = members
        members.filter { it != group.here && it !in peers }.forEach { peers[it] = Peer(it) }
        forgetOld()
        rivalSince = if (members.none(::isOlderRival)) null else rivalSince ?: loop.now()
        watch()
        val computers = members.asReversed().associateBy { it.name }
        val next = ClusterView(computers, hosts.count { it in computers } * 2 > hosts.size)
        loop.execute {
            lost.forEach(::end)
            tell { listener.changed(next) }
        }
    }

    private fun giveUp(member: Computer, reason: String): List<Outgoing.End> {
        val outgoing = peers[member]?.outgoing ?: return emptyList()
        nextPiece = maxOf(nextPiece, outgoing.next)
        return outgoing.giveUp(reason)
    }

    /** Forgets the sessions of lost members except the last [MAX_GONE]. A returning member continues its session. */
    private fun forgetOld() {
        val gone = peers.keys.filter { it !in members }
        peers.keys.removeAll(gone.dropLast(MAX_GONE).toSet())
    }

    /** Returns true if [member] has this computer's name and is older. A rival is the previous run of this program, or another computer. */
    private fun isOlderRival(member: Computer) =
        member.name == here && member != group.here && members.indexOf(member) < members.indexOf(group.here)

    private fun tick() {
        val now = loop.now()
        val isRefused = synchronized(lock) {
            isWatching = false
            watch()
            members.forEach { member ->
                val outgoing = peers[member]?.outgoing ?: return@forEach
                outgoing.overdue(now)?.let { group.transmit(member, it.bytes()) }
            }
            rivalSince?.let { now - it >= RIVAL_NANOS } ?: false
        }
        if (isRefused) refuse("another computer of the fleet is called $here already: give this one a name of its own")
    }

    /** Leaves the fleet, and tells the listener the [reason]. */
    internal fun refuse(reason: String) {
        if (isClosed) return
        loop.execute { tell { listener.refused(reason) } }
        close()
    }

    private fun tell(call: () -> Unit) = try {
        call()
    } catch (@Suppress("TooGenericExceptionCaught") e: Throwable) {
        LOG.log(System.Logger.Level.ERROR, "the listener of the cluster failed", e)
    }

    override fun close() {
        val lost = synchronized(lock) {
            if (isClosed) return
            isClosed = true
            members.flatMap { giveUp(it, "this computer, $here, has left the fleet") }
        }
        loop.execute { lost.forEach(::end) }
        group.close()
        loop.close()
    }

    private companion object {
        val LOG: System.Logger = System.getLogger(Cluster::class.java.name)
        const val TICK_MILLIS = 100L

        /** While the listener is busy, a sender gets an acknowledgement after this number of pieces. */
        const val ANSWER_EVERY = 32L

        /** The group detects the end of this program's previous run within this time. */
        const val RIVAL_NANOS = 5_000_000_000L
        const val MAX_GONE = 256
    }
}
