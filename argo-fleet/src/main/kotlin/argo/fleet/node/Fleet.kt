package argo.fleet.node

import argo.fleet.cluster.Cluster
import argo.fleet.cluster.ClusterListener
import argo.fleet.cluster.ClusterView
import argo.fleet.cluster.Computer
import argo.fleet.cluster.Overloaded
import argo.fleet.cluster.Refused
import argo.fleet.cluster.Unreachable
import java.net.InetSocketAddress
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.logging.Logger
import kotlin.random.Random

/** What a fleet needs of this computer's agents. The cluster's thread calls these functions, which must not wait. */
internal interface LocalAgents {
    /** Puts [message] into its receiver's mailbox. @throws Refused if the receiver is not here, or cannot read [message] */
    fun take(message: Say)

    /** Fails the question of an agent, if the agent is here and still waits for the answer. */
    fun take(message: Unanswered)

    /** Kills an agent. @throws Refused if the agent is not here, or cannot be killed */
    fun kill(wanted: Kill)

    fun stop(wanted: Stop)

    /** The agents, services or computers in touch have changed. Threads of agents also call this function. */
    fun directoryChanged(before: Directory, now: Directory)

    /** This computer cannot stay in the fleet, for [reason]. */
    fun refused(reason: String)
}

/**
 * Connects this computer with the others of its fleet: tells the other computers its agents and services, knows theirs, and sends messages.
 *
 * Safe for use by several threads, never blocks.
 *
 * @param planned the agents of the project, each with the computers that it may run on
 * @property hosts the addresses of the computers that the project names
 * @property views the ports of live views of agents of the project
 */
internal class Fleet(
    private val cluster: Cluster,
    planned: Map<String, List<String>>,
    val hosts: Map<String, InetSocketAddress>,
    private val log: Logger,
    val views: Map<String, Int> = emptyMap(),
) : AutoCloseable {
    private lateinit var agents: LocalAgents
    private lateinit var takeover: Takeover
    private val movable = planned.filterValues { it.size > 1 }.keys // the agents that outlive their computers
    private val sessions = HashMap<String, String>() // each computer's last session; for the cluster's thread
    private var differing = emptyMap<String, Int>() // the last digests told that differ here, by computer; for the cluster's thread
    private val told = ConcurrentHashMap.newKeySet<String>() // the lines that were logged once and must not be repeated
    private val met = CompletableFuture<Unit>()

    /** The present places of agents and services. */
    @Volatile
    var directory = Directory(cluster.here, planned = planned, hosts = hosts.keys)
        private set

    val here: String get() = cluster.here

    /** Joins the fleet. From now on, the fleet calls [agents] and [takeover]. */
    fun join(agents: LocalAgents, takeover: Takeover) {
        this.agents = agents
        this.takeover = takeover
        cluster.listen(Listener())
    }

    /** Waits until all computers that are in touch now have told their agents, at most [millis] ms. */
    fun awaitOthers(millis: Long) {
        met.completeOnTimeout(Unit, millis, TimeUnit.MILLISECONDS).join()
    }

    /** Sends [message] to another [computer]; completes or fails as [Cluster.send] does. */
    fun send(computer: String, message: FleetMessage): CompletionStage<Void> = cluster.send(computer, message.encode())

    /** Sends [message] to all other computers in touch; each send completes or fails as [Cluster.send] does. */
    fun sendOthers(message: FleetMessage): Map<String, CompletionStage<Void>> {
        val others = directory.inTouch - here
        if (others.isEmpty()) return emptyMap()
        val bytes = message.encode()
        return others.associateWith { cluster.send(it, bytes) }
    }

    /** Tells the fleet that [agent] has begun on this computer. */
    fun came(agent: String) = tell(RosterNews(came = setOf(agent)))

    /** Tells the fleet that [agent] has ended on this computer, together with its services. */
    fun gone(agent: String) = synchronized(this) {
        tell(RosterNews(gone = setOf(agent), withdrawn = directory.roster(here).offers.filter { it.agent == agent }.toSet()))
    }

    /** Tells the fleet that this computer cannot run [agent], which outlives its computer, so that another computer starts it. */
    fun cannotRun(agent: String) = tell(RosterNews(unable = setOf(agent)))

    /** Tells the fleet that this computer will try again to start [agent] if the agent is missing. */
    fun canRun(agent: String) = tell(RosterNews(able = setOf(agent)))

    fun offer(offer: Offer) = tell(RosterNews(offered = setOf(offer)))

    fun withdraw(offer: Offer) = tell(RosterNews(withdrawn = setOf(offer)))

    /**
     * Tells another computer, chosen by [random], which rosters this computer knows. Call this now and then: whatever causes a computer to
     * miss news of another one, it then notices that and asks.
     */
    fun compare(random: Random) {
        val now = directory
        (now.inTouch - here).randomOrNull(random)?.let { send(it, Known(now.digests)) }
    }

    /** Tells all computers in touch to stop. Completes when each computer has been told or is lost, or after two seconds. */
    fun stopOthers(wanted: Stop): CompletionStage<Void> {
        val told = sendOthers(wanted).map { (computer, end) ->
            end.handle { _, lost ->
                if (lost != null) log.warning("$computer has not been told to stop: ${lost.message}")
            }.toCompletableFuture()
        }
        return CompletableFuture.allOf(*told.toTypedArray()).completeOnTimeout(null, STOP_PATIENCE_S, TimeUnit.SECONDS)
    }

    override fun close() = cluster.close()

    private fun tell(news: RosterNews) = synchronized(this) {
        change { it.with(here, news) }
        sendOthers(news).forEach { (computer, end) -> repeatIfLost(computer, end) }
    }

    private fun tellAll(computer: String, asksBack: Boolean = false) = synchronized(this) {
        if (computer !in directory.inTouch) return@synchronized
        val mine = directory.roster(here)
        val whole = RosterNews(isWhole = true, came = mine.agents, offered = mine.offers, unable = mine.unable, asksBack = asksBack)
        repeatIfLost(computer, send(computer, whole))
    }

    /** If news to [computer] fails, as [end] tells, and [computer] is still in touch, tells it everything anew a little later. */
    private fun repeatIfLost(computer: String, end: CompletionStage<Void>) {
        end.exceptionally { failed ->
            if (failed.reason() is Refused) once("$computer does not take the agents and services of $here: ${failed.reason().message}")
            else if (computer in directory.inTouch) {
                if (failed.reason() is Overloaded) once("$computer does not take all agents and services of $here: they are too much")
                CompletableFuture.delayedExecutor(RETRY_MS, TimeUnit.MILLISECONDS).execute { tellAll(computer) }
            }
            null
        }
    }

    /** Changes the directory. Call this under the lock, so that other computers hear of the changes in the right order. */
    private fun change(how: (Directory) -> Directory) {
        val before = directory
        directory = how(before)
        if (::agents.isInitialized && directory != before) agents.directoryChanged(before, directory)
    }

    private fun noteMet() {
        if (directory.run { inTouch.all(::isMet) }) met.complete(Unit)
    }

    private fun once(line: String) {
        if (told.size < MOST_TOLD && told.add(line)) log.severe(line)
    }

    private inner class Listener : ClusterListener {
        override fun message(from: String, message: ByteArray) {
            val read = try {
                FleetMessage.decode(message)
            } catch (unreadable: UnreadableMessage) {
                once("a message of $from is refused: ${unreadable.message}")
                throw Refused(NOT_READABLE, unreadable.message)
            }
            when (read) {
                is Say -> take(from, read)
                is Unanswered -> agents.take(read)
                is RosterNews -> take(from, read)
                is Known -> take(from, read)
                is Kill -> agents.kill(read)
                is Stop -> agents.stop(read)
                is Claim, is Grant, is MindNews -> takeover.take(from, read)
            }
        }

        private fun take(from: String, message: Say) {
            if (takeover.isOutdated(message)) throw Refused("moved", "${message.from} runs on another computer now")
            if (message.from !in directory.roster(from).agents) {
                once("a message of ${message.from} is refused: it comes from $from, which has no such agent")
                throw Refused("not_sender", "$from has no agent ${message.from}")
            }
            agents.take(message)
        }

        private fun take(from: String, news: RosterNews) = synchronized(this@Fleet) {
            (news.came - movable).intersect(directory.roster(here).agents).forEach {
                once("an agent called $it runs here and on $from: these send to their own one, others to that of ${minOf(here, from)}")
            }
            change { it.with(from, news) }
            noteMet()
            if (news.asksBack) tellAll(from)
        }

        /**
         * Asks each computer whose roster differs here for the second time. The first time, its news may still be on their way. The news of
         * [from] have all come before [known], so [from] itself is asked at once.
         */
        private fun take(from: String, known: Known) {
            val mine = directory.digests
            val others = (known.digests - here).filter { (computer, digest) -> computer in directory.inTouch && mine[computer] != digest }
            val missed = others.filter { (computer, digest) -> computer == from || differing[computer] == digest }.keys
            differing += others // also after news of a computer that has missed the same as this one
            missed.forEach {
                log.info("$from knows other agents or services of $it than $here does, so $here asks for them")
                tellAll(it, asksBack = true)
            }
        }

        override fun changed(view: ClusterView) {
            synchronized(this@Fleet) {
                val others = view.computers.values.filter { it.name != here }
                val begun = others.filter { sessions.put(it.name, it.session) != it.session }
                val come = others.filter { it in begun || it.name !in directory.inTouch }
                // a computer whose program goes on may not know that it was lost. Its roster here stays valid, and it tells later changes
                change { it.without(begun.map(Computer::name)).with(view.computers.keys) }
                noteMet()
                come.forEach { tellAll(it.name, asksBack = it in begun) } // that computer may not know that its roster is missing here
            }
            takeover.changed(view)
        }

        override fun refused(reason: String) = agents.refused(reason)
    }

    private companion object {
        const val STOP_PATIENCE_S = 2L
        const val RETRY_MS = 500L
        const val MOST_TOLD = 100
    }
}

/** Returns the exception with which a stage failed, without the wrapper that stages may add. */
internal fun Throwable.reason(): Throwable = if (this is java.util.concurrent.CompletionException) cause ?: this else this

/** Returns the failure of a message to [agent], which no computer in touch runs. */
internal fun unreachable(agent: String, place: Place.Off, now: Directory): Unreachable {
    val off = place.computers - now.inTouch
    val unmet = place.computers.filter { it in now.inTouch && !now.isMet(it) }
    val reason = when {
        unmet.isNotEmpty() -> "${unmet.joinToString(" and ")} has not told its agents yet"
        off.isEmpty() -> "none of ${place.computers.joinToString(" and ")} runs it now"
        else -> "${off.joinToString(" and ")} ${if (off.size == 1) "is" else "are"} off"
    }
    return Unreachable("$agent cannot be reached: $reason")
}

/** The error for a message that arrived but cannot be read. */
internal const val NOT_READABLE = "not_readable"
