package argo.fleet.node

import argo.fleet.cluster.Cluster
import argo.fleet.cluster.ClusterListener
import argo.fleet.cluster.ClusterView
import argo.fleet.cluster.Refused
import argo.fleet.cluster.Unreachable
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.logging.Logger

/** The agents of this computer, as the fleet needs them. Functions are called by the cluster's thread, and do not wait. */
internal interface LocalAgents {
    /** Puts [message] into the mailbox of its receiver. @throws Refused if it is not here, or cannot read it */
    fun take(message: Say)

    /** Kills an agent. @throws Refused if it is not here, or does not allow that */
    fun kill(wanted: Kill)

    fun stop(wanted: Stop)

    /** Other agents, services or computers are in touch now. Also called by threads of agents. */
    fun directoryChanged(before: Directory, now: Directory)

    /** This computer cannot stay in the fleet, for [reason]. */
    fun refused(reason: String)
}

/**
 * This computer among those of its fleet: tells the others which agents and services are here, knows theirs, and takes messages to them.
 *
 * Safe for use by several threads, never blocks.
 *
 * @param planned the agents of the project, each with the computers that it may run on
 */
internal class Fleet(
    private val cluster: Cluster,
    planned: Map<String, List<String>>,
    hosts: Set<String>,
    private val log: Logger,
) : AutoCloseable {
    private lateinit var agents: LocalAgents
    private lateinit var leases: Leases
    private val sessions = HashMap<String, String>() // of the computers in touch; the cluster's thread
    private val told = ConcurrentHashMap.newKeySet<String>() // what the log has said once

    /** Who is where now. */
    @Volatile
    var directory = Directory(cluster.here, planned = planned, hosts = hosts)
        private set

    val here: String get() = cluster.here

    /** Joins the fleet: from now on [agents] and [leases] are called. */
    fun join(agents: LocalAgents, leases: Leases) {
        this.agents = agents
        this.leases = leases
        cluster.listen(Listener())
    }

    /** Sends [message] to another [computer]; completes or fails as [Cluster.send] does. */
    fun send(computer: String, message: FleetMessage): CompletionStage<Void> = cluster.send(computer, message.encode())

    /** An agent of this computer has begun. */
    fun came(agent: String) = tell(RosterNews(came = setOf(agent)))

    /** An agent of this computer has ended; its services end too. */
    fun gone(agent: String) = synchronized(this) {
        tell(RosterNews(gone = setOf(agent), withdrawn = directory.roster(here).offers.filter { it.agent == agent }.toSet()))
    }

    fun offer(offer: Offer) = tell(RosterNews(offered = setOf(offer)))

    fun withdraw(offer: Offer) = tell(RosterNews(withdrawn = setOf(offer)))

    /**
     * Tells all computers in touch to stop. Completes when each has been told, or is lost, or two seconds are over.
     */
    fun stopOthers(wanted: Stop): CompletionStage<Void> {
        val told = (directory.inTouch - here).map { computer ->
            send(computer, wanted).handle { _, lost ->
                if (lost != null) log.warning("$computer has not been told to stop: ${lost.message}")
            }.toCompletableFuture()
        }
        return CompletableFuture.allOf(*told.toTypedArray()).completeOnTimeout(null, STOP_PATIENCE_S, TimeUnit.SECONDS)
    }

    override fun close() = cluster.close()

    private fun tell(news: RosterNews) = synchronized(this) {
        change { it.with(here, news) }
        (directory.inTouch - here).forEach { sendRoster(it, news) }
    }

    private fun tellAll(computer: String) = synchronized(this) {
        if (computer !in directory.inTouch) return@synchronized
        val mine = directory.roster(here)
        sendRoster(computer, RosterNews(isWhole = true, came = mine.agents, offered = mine.offers))
    }

    /** Sends [news]. If they do not arrive although [computer] stays in touch, it is told everything anew a little later. */
    private fun sendRoster(computer: String, news: RosterNews) {
        send(computer, news).exceptionally { failed ->
            if (computer in directory.inTouch && failed.reason() !is Refused) {
                CompletableFuture.delayedExecutor(RETRY_MS, TimeUnit.MILLISECONDS).execute { tellAll(computer) }
            }
            null
        }
    }

    /** Changes the directory, under the lock, so that computers hear of changes in their order. */
    private fun change(how: (Directory) -> Directory) {
        val before = directory
        directory = how(before)
        if (::agents.isInitialized && directory != before) agents.directoryChanged(before, directory)
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
                throw unreadable
            }
            when (read) {
                is Say -> take(read)
                is RosterNews -> take(from, read)
                is Kill -> agents.kill(read)
                is Stop -> agents.stop(read)
                is Claim, is Grant, is MindNews -> leases.take(from, read)
            }
        }

        private fun take(message: Say) {
            if (leases.isOutdated(message)) throw Refused("${message.from} runs on another computer now")
            agents.take(message)
        }

        private fun take(from: String, news: RosterNews) = synchronized(this@Fleet) {
            (news.came - directory.planned.filterValues { it.size > 1 }.keys).intersect(directory.roster(here).agents).forEach {
                once("an agent called $it runs here and on $from: these send to their own one, others to that of ${minOf(here, from)}")
            }
            change { it.with(from, news) }
        }

        override fun changed(view: ClusterView) {
            synchronized(this@Fleet) {
                val new = view.computers.values.filter { it.name != here && sessions[it.name] != it.session }
                sessions.clear()
                view.computers.values.forEach { sessions[it.name] = it.session }
                change { known -> new.fold(known) { now, it -> now.with(it.name, RosterNews(isWhole = true)) }.with(view.computers.keys) }
                new.forEach { tellAll(it.name) }
            }
            leases.changed(view)
        }

        override fun refused(reason: String) = agents.refused(reason)
    }

    private companion object {
        const val STOP_PATIENCE_S = 2L
        const val RETRY_MS = 500L
        const val MOST_TOLD = 100
    }
}

/** The reason for which a stage failed; stages may wrap it. */
internal fun Throwable.reason(): Throwable = if (this is java.util.concurrent.CompletionException) cause ?: this else this

/** Returns the failure of a message to [agent], of whose [computers] none is in touch. */
internal fun unreachable(agent: String, computers: List<String>) =
    Unreachable("$agent cannot be reached: ${computers.joinToString(" and ")} ${if (computers.size == 1) "is" else "are"} off")
