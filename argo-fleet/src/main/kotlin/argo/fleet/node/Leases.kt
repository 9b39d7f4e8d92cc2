package argo.fleet.node

import argo.fleet.cluster.ClusterView
import argo.fleet.cluster.Refused
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.Executors
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.TimeUnit
import java.util.logging.Level
import java.util.logging.Logger
import kotlin.random.Random

/** Starts and stops agents that outlive their computers. One thread of [Leases] calls these functions. */
internal interface LeasedAgents {
    /**
     * Starts [agent] with [mind] after this call returns; null: the agent's mind is not known, or this is its first start. If the start
     * or the agent's thread fails, calls [Leases.cannotRun]. If [reign] has ended before the start, calls [Leases.giveUp].
     */
    fun start(agent: String, reign: Reign, mind: MindNews?)

    /** Stops [agent] after this call returns. Until then the agent does nothing, since its reign is over. */
    fun stop(agent: String)
}

/** The time during which this computer runs an agent. */
internal class Reign(private val lease: Lease, val term: Long) {
    /** Whether the agent may run now. Any thread. */
    fun isValid(): Boolean = lease.mayRun() && lease.ownTerm == term
}

/**
 * Decides which of the agents that outlive their computers run on this computer. A missing agent starts on the first of its computers that
 * is in touch, and stays there until that computer is lost.
 *
 * @param planned the agents that outlive their computers, each with the computers that it may run on
 * @param hosts the number of computers of the fleet
 * @param nanos a clock in ns that never goes back
 */
internal class Leases(
    private val fleet: Fleet,
    planned: Map<String, List<String>>,
    hosts: Int,
    private val agents: LeasedAgents,
    private val log: Logger,
    private val nanos: () -> Long = System::nanoTime,
) : AutoCloseable {
    private val start = nanos()
    private val held = planned.mapValues { (agent, computers) ->
        Held(agent, computers, Lease(hosts, start, Random.nextLong(), nanos, System::currentTimeMillis))
    }
    private val behind = ConcurrentHashMap.newKeySet<Pair<String, String>>() // a computer, and an agent whose mind it lacks
    private val timer: ScheduledExecutorService = Executors.newSingleThreadScheduledExecutor { work ->
        Thread(work, "argo-fleet-leases").apply { isDaemon = true }
    }

    @Volatile
    private var hasMajority = false

    /** Begins to claim agents. */
    fun begin() {
        if (held.isEmpty()) return
        timer.scheduleWithFixedDelay(::tick, 0, PERIOD_MS, TimeUnit.MILLISECONDS)
    }

    fun take(from: String, message: FleetMessage) = synchronized(this) {
        when (message) {
            is Claim -> held(message.agent).answer(from, message)
            is Grant -> held(message.agent).take(from, message)
            is MindNews -> held(message.agent).take(message)
            else -> throw Refused("not_leased", "$message is not about an agent that outlives its computer")
        }
        Unit
    }

    private fun held(agent: String) = held[agent]
        ?: throw Refused("not_leased", "$agent outlives no computer by the project of ${fleet.here}; all computers need the same project")

    fun changed(view: ClusterView) {
        hasMajority = view.hasMajority
    }

    /** Returns true if this computer knows that another computer has since taken over the agent that sent [message]. */
    fun isOutdated(message: Say): Boolean =
        message.term != 0L && synchronized(this) { message.term < (held[message.from]?.lease?.term ?: 0) }

    /**
     * Notes the mind of an agent that this computer runs, and sends it to all other computers in touch. So at least one of the computers
     * that grant the agent's next reign has the mind. Any thread may call this.
     *
     * @return completed when all of these computers have the mind. Fails if one of them does not get it; the log then warns once, and again
     * only after that computer has got a newer mind
     */
    fun keep(mind: MindNews): CompletionStage<Void> {
        synchronized(this) { held(mind.agent).take(mind) }
        val ends = fleet.sendOthers(mind).map { (computer, end) ->
            end.whenComplete { _, failed ->
                if (failed == null) behind -= computer to mind.agent
                else if (behind.add(computer to mind.agent)) {
                    log.warning("$computer has not got what ${mind.agent} believes, and is told again: ${failed.reason().message}")
                }
            }.toCompletableFuture()
        }
        return CompletableFuture.allOf(*ends.toTypedArray())
    }

    /**
     * Gives up [reign] over [agent], which this computer cannot start or go on with for [reason], so that the next computer runs it. Later
     * this computer may try again. Any thread may call this.
     */
    fun cannotRun(agent: String, reign: Reign, reason: Throwable) {
        fleet.cannotRun(agent) // first, or this computer would claim the agent again at once
        synchronized(this) { held(agent).cannotRun(reign, reason) }
    }

    /** Gives up [reign] over [agent]; this computer may claim the agent again. Any thread may call this. */
    fun giveUp(agent: String, reign: Reign) = synchronized(this) { held(agent).giveUp(reign) }

    override fun close() {
        timer.shutdownNow()
    }

    private fun tick() = try {
        synchronized(this) { held.values.filter { fleet.here in it.computers }.forEach { it.tick() } }
    } catch (@Suppress("TooGenericExceptionCaught") unexpected: Throwable) { // an exception would end the timer
        log.log(Level.SEVERE, unexpected) { "agents that outlive their computers: ${unexpected.message}" }
    }

    /** An agent that outlives its computer. */
    private inner class Held(val agent: String, val computers: List<String>, val lease: Lease) {
        private var mind: MindNews? = null
        private var reign: Reign? = null
        private var missingSince: Long? = null
        private val retry = Retry(nanos)
        private var told: String? = null // the last reason why this computer could not run the agent

        fun take(news: MindNews) {
            val known = mind
            if (known == null || news.isNewerThan(known.term, known.number)) mind = news
        }

        /** Answers a claim. If the claimant has an older mind of the agent or none, sends it the newer mind first. */
        fun answer(computer: String, claim: Claim) {
            val grant = lease.answer(computer, claim)
            val known = mind
            if (grant.isGranted && known != null && known.isNewerThan(claim.mindTerm, claim.mindNumber)) fleet.send(computer, known)
            fleet.send(computer, grant)
        }

        fun tick() {
            val running = reign
            if (running != null && !running.isValid()) {
                log.severe("$agent stops here: most computers of the fleet have not confirmed in time that it may run; another may")
                giveUp(running)
                agents.stop(agent)
            }
            if (retry.isDue()) fleet.canRun(agent)
            if (reign != null || isMine()) claim()
        }

        fun take(computer: String, grant: Grant) {
            lease.take(computer, grant)
            if (reign == null && lease.ownTerm != 0L && lease.mayRun()) begin()
        }

        fun giveUp(failed: Reign) {
            if (reign !== failed) return
            reign = null
            lease.giveUp()
        }

        fun cannotRun(failed: Reign, reason: Throwable) {
            giveUp(failed)
            val seconds = TimeUnit.NANOSECONDS.toSeconds(retry.failed())
            if ("$reason" != told) {
                log.log(Level.SEVERE, reason) {
                    "$agent cannot run here: ${reason.message}; if no other computer runs it, this one tries again in $seconds s," +
                        " and then more and more rarely"
                }
            }
            told = "$reason"
        }

        private fun begin() {
            val begun = Reign(lease, lease.ownTerm)
            reign = begun
            agents.start(agent, begun, mind)
        }

        /** Whether this computer should start the agent: no computer in touch runs it, and this is the first that can. */
        private fun isMine(): Boolean {
            val directory = fleet.directory
            val isMissing = hasMajority && directory.find(agent) is Place.Off
            if (!isMissing) missingSince = null else if (missingSince == null) missingSince = nanos()
            val since = missingSince ?: return false.also { lease.giveUp() }
            val first = computers.find { it in directory.inTouch && agent !in directory.roster(it).unable }
            // only the agent's first computer starts it at once: computers that begin together must find each other first
            return first == fleet.here && (first == computers.first() || nanos() - since > PATIENCE_NS || nanos() - start > BEGINNING_NS)
        }

        private fun claim() {
            val claim = lease.claim(agent).copy(mindTerm = mind?.term ?: 0, mindNumber = mind?.number ?: 0)
            take(fleet.here, lease.answer(fleet.here, claim))
            fleet.sendOthers(claim)
        }
    }

    private companion object {
        /** A fifth of a lease's duration, so that four messages in a row may be late. */
        const val PERIOD_MS = 300L
        const val PATIENCE_NS = 2_000_000_000L
        const val BEGINNING_NS = 10_000_000_000L
    }
}
