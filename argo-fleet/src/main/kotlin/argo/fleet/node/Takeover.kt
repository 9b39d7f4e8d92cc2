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

/** Starts and stops agents that outlive their computers. One thread of [Takeover] calls these functions. */
internal interface LeasedAgents {
    /**
     * Starts [agent] with [mind] after this call returns; null: the agent's mind is not known, or this is its first start. If the start
     * or the agent's thread fails, calls [Takeover.cannotRun]. If [reign] has ended before the start, calls [Takeover.giveUp].
     */
    fun start(agent: String, reign: Reign, mind: MindNews?)

    /** Stops [agent] after this call has returned. The agent does nothing until then, since its reign is over. */
    fun stop(agent: String)
}

/** The time for which this computer runs an agent. */
internal class Reign(private val lease: Lease, val term: Long) {
    /** Returns true if the agent may run now. Safe for use by several threads. */
    fun isValid(): Boolean = lease.mayRun() && lease.ownTerm == term
}

/**
 * Decides which agents that outlive their computers run on this computer. A missing agent starts on the first of its computers that is in
 * touch. The agent stays there until that computer is lost.
 *
 * @param planned the computers that may run each agent that outlives its computer
 * @param hosts the number of computers of the fleet
 * @param nanos a clock in ns that never goes back
 */
internal class Takeover(
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

    // pairs of a computer and an agent whose mind the computer lacks
    private val behind = ConcurrentHashMap.newKeySet<Pair<String, String>>()
    private val timer: ScheduledExecutorService = Executors.newSingleThreadScheduledExecutor { work ->
        Thread(work, "argo-fleet-takeover").apply { isDaemon = true }
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

    /** Returns true if another computer has taken over the sender of [message], as this computer knows. */
    fun isOutdated(message: Say): Boolean =
        message.term != 0L && synchronized(this) { message.term < (held[message.from]?.lease?.term ?: 0) }

    /**
     * Stores the mind of an agent that this computer runs, and sends it to all other computers in touch. At least one of the computers that
     * grant the next reign over the agent then has the mind. Safe for use by several threads.
     *
     * @return completes when all of these computers have the mind. Fails if one of them does not get it. The log warns once per computer,
     * and again only after that computer has got a newer mind
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
     * Gives up [reign] over [agent], which this computer cannot run for [reason]. The next computer then runs it. This computer may try
     * again later. Safe for use by several threads.
     */
    fun cannotRun(agent: String, reign: Reign, reason: Throwable) {
        fleet.cannotRun(agent) // comes first, since this computer would otherwise claim the agent again at once
        synchronized(this) { held(agent).cannotRun(reign, reason) }
    }

    /** Gives up [reign] over [agent]. This computer may claim the agent again. Safe for use by several threads. */
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
        private val refusing = ConcurrentHashMap.newKeySet<String>() // the computers that take no claims
        private var told: String? = null // the last logged reason why this computer could not run the agent

        fun take(news: MindNews) {
            val known = mind
            if (known == null || news.isNewerThan(known.term, known.number)) mind = news
        }

        /** Answers a claim. If the claimant lacks the newest mind of the agent, sends that mind first. */
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

        /** Returns true if this computer should start the agent. No computer in touch runs it, and this is the first that can. */
        private fun isMine(): Boolean {
            val directory = fleet.directory
            val isMissing = hasMajority && directory.find(agent) is Place.Off
            if (!isMissing) missingSince = null else if (missingSince == null) missingSince = nanos()
            val since = missingSince ?: return false.also { lease.giveUp() }
            val first = computers.find { it in directory.inTouch && agent !in directory.roster(it).unable }
            // only the agent's first computer starts it at once, since computers that start together must find each other first
            return first == fleet.here && (first == computers.first() || nanos() - since > PATIENCE_NS || nanos() - start > BEGINNING_NS)
        }

        private fun claim() {
            val claim = lease.claim(agent).copy(mindTerm = mind?.term ?: 0, mindNumber = mind?.number ?: 0)
            take(fleet.here, lease.answer(fleet.here, claim))
            fleet.sendOthers(claim).forEach { (computer, end) -> tellRefusal(computer, end) }
        }

        /** Tells once why [computer] takes no claim: by its project, the agent may outlive no computer. */
        private fun tellRefusal(computer: String, end: CompletionStage<Void>) {
            end.exceptionally { failed ->
                val reason = failed.reason()
                if (reason is Refused && refusing.add(computer)) log.severe("$computer does not let $agent run here: ${reason.message}")
                null
            }
        }
    }

    private companion object {
        /** The interval of claims. The interval is a fifth of a lease, so that four messages in a row may be late. */
        const val PERIOD_MS = 300L
        const val PATIENCE_NS = 2_000_000_000L
        const val BEGINNING_NS = 10_000_000_000L
    }
}
