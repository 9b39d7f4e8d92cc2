package argo.fleet.agents

import argo.fleet.cluster.Refused
import argo.fleet.cluster.Unreachable
import argo.fleet.node.Directory
import argo.fleet.node.Fleet
import argo.fleet.node.MindNews
import argo.fleet.node.NOT_READABLE
import argo.fleet.node.Place
import argo.fleet.node.Reign
import argo.fleet.node.Say
import argo.fleet.node.Unanswered
import argo.fleet.node.unreachable
import argo.mind.Mind
import argo.observing.AgentThere
import argo.observing.ObservedComputer
import argo.observing.SeveralComputers
import argo.recording.agent.MessageContent
import jason.JasonException
import jason.architecture.AgArch
import jason.asSemantics.Agent
import jason.asSemantics.CircumstanceListener
import jason.asSemantics.Event
import jason.asSemantics.Message
import jason.asSyntax.Literal
import jason.infra.local.LocalAgArch
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The infrastructure of an agent in a [Fleet]: the last of its architectures. The agent can also send messages to agents of other
 * computers.
 *
 * @param reign the time for which an agent that outlives its computer runs here, or null for another agent
 * @param begun the first mind of such an agent, or null if it starts as its program says
 * @param keep takes the mind of such an agent. The function fails if a computer that may run the agent did not get the mind
 * @param failed takes the error that ended the agent's thread
 */
internal class FleetAgArch(
    private val fleet: Fleet,
    private val reign: Reign? = null,
    private val begun: MindNews? = null,
    private val keep: (MindNews) -> CompletionStage<Void> = { CompletableFuture.completedStage(null) },
    private val failed: (Throwable) -> Unit = { throw it },
) : LocalAgArch(), SeveralComputers {
    /** The term of the reign in which the agent runs here, or 0 if it does not outlive its computer. */
    val term: Long = reign?.term ?: 0
    private val questions = Questions()
    private val sleepLock = ReentrantLock()
    private val woken = sleepLock.newCondition()
    private var isWoken = false
    private var sleepMs = FIRST_SLEEP_MS
    private var kept: Mind? = null
    private val leftOut = HashSet<String>()
    private var keptNs = 0L
    private var minds = 0L

    @Volatile
    private var isTold = false // true if all computers that may run the agent have its mind

    @Volatile
    private var percepts: FleetPercepts? = null

    /**
     * Jason calls this function between reading the program and making the agent's other architectures. One of these may record the agent.
     */
    override fun insertAgArch(arch: AgArch) {
        super.insertAgArch(arch)
        if (arch !== this) return
        FleetActions.install(ts.ag, questions)
        ts.c.addEventListener(object : CircumstanceListener {
            override fun eventAdded(event: Event) = wake() // events of other threads in the project may not wake the agent
        })
        percepts = FleetPercepts.of(ts.settings.getUserParameter(FleetPercepts.OPTION), logger::severe)
        begun?.let(::goOnWith)
    }

    private fun goOnWith(mind: MindNews) = try {
        restore(ts, mind.program, logger)
    } catch (unreadable: IllegalArgumentException) {
        logger.severe("$agName begins anew, since what it believed cannot be read: ${unreadable.message}")
    }

    override fun sendMsg(message: Message) {
        if (message.sender == null) message.sender = agName
        if (!mayRun()) throw held()
        val directory = fleet.directory
        when (val place = directory.find(message.receiver)) {
            Place.Here -> super.sendMsg(message)
            is Place.There -> send(message, place.computer)
            is Place.Off -> throw errorOf(unreachable(message.receiver, place, directory))
            Place.Unknown ->
                if (isRunning) throw noAgent("there is no agent ${message.receiver} in the fleet; the message is ${shown(message)}")
        }
    }

    private fun send(message: Message, computer: String) {
        val content = try {
            MessageContent.write(message.propCont)
        } catch (refused: IllegalArgumentException) {
            val reason = Refused("not_sendable", "${shown(message)} cannot go to another computer: ${refused.message}")
            tellUnanswered(message, computer, reason)
            throw errorOf(reason)
        }
        if (message.isAsk && message.msgId.startsWith(Message.msgIdSyncAskPrefix)) questions.ask(message.msgId, message.receiver, computer)
        val said = Say(message.msgId, message.inReplyTo, message.ilForce, message.sender, message.receiver, content, term)
        val end = fleet.send(computer, said)
        end.whenComplete { _, failed -> if (failed != null) tellUnanswered(message, computer, refusalOf(failed)) }
        Deliveries.add(Delivery(message.msgId, message.receiver, logger, end))
    }

    /**
     * If [answer] answers a question, tells the asker that it does not arrive at [computer] because of [reason]. An asker that is out of
     * touch detects it itself.
     */
    private fun tellUnanswered(answer: Message, computer: String, reason: Refused) {
        val question = answer.inReplyTo ?: return
        val words = "$agName has answered in vain: ${reason.message}".take(MAX_REASON)
        fleet.send(computer, Unanswered(question, answer.receiver, reason.error, words))
    }

    /**
     * Fails the question whose answer does not arrive. Logs the failure if no intention waits for the answer. Safe for use by several
     * threads.
     */
    fun take(message: Unanswered) {
        val isTold = questions.fail(message.question, Refused(message.error, message.reason))
        if (!isTold) logger.warning("a question gets no answer: ${message.reason}")
    }

    /** Sends [message] to all other agents. If sending to some agents fails, the others still get [message]. */
    override fun broadcast(message: Message) {
        val failures = (fleet.directory.names - agName).mapNotNull { receiver ->
            try {
                firstAgArch.sendMsg(message.clone().apply { this.receiver = receiver })
                null
            } catch (failed: JasonException) {
                failed
            }
        }
        failures.drop(1).forEach { logger.warning("a message to all has not arrived: ${it.message}") }
        failures.firstOrNull()?.let { throw it }
    }

    /** Takes [message] from an agent of another computer. Any thread. @throws Refused if its content cannot be read */
    fun take(message: Say) {
        val content = try {
            readForeign(message.content, ts.ag)
        } catch (unreadable: IllegalArgumentException) {
            refuse(message, "${unreadable.message}")
        } catch (_: StackOverflowError) {
            refuse(message, "it is nested too deep")
        }
        receiveMsg(
            Message(message.force, message.from, message.to, content, message.id).apply { inReplyTo = message.inReplyTo },
        )
    }

    private fun refuse(message: Say, reason: String): Nothing {
        logger.warning("a message of ${message.from} cannot be read and is refused: $reason")
        throw Refused(NOT_READABLE, "${message.to} cannot read the message: $reason")
    }

    override fun receiveMsg(message: Message) {
        message.inReplyTo?.let { questions.answered(it, message.sender) }
        super.receiveMsg(message)
    }

    /**
     * Fails intentions that wait for an answer from a lost computer. Wakes an agent that perceives the fleet. Safe for use by several
     * threads.
     */
    fun directoryChanged(now: Directory) {
        questions.failLost(now)
        isTold = false
        if (percepts != null) wake()
    }

    override val computers: List<ObservedComputer> get() = fleet.directory.run {
        computers.map { computer ->
            val agents = agentsOf[computer].orEmpty().map { AgentThere(it, fleet.views[it]) }
            val address = fleet.hosts[computer]
            val isNear = computer == here || address?.address?.isLoopbackAddress == true
            ObservedComputer(computer, address?.hostString ?: computer, computer == here, isNear, isMet(computer), agents)
        }
    }

    override fun perceive(): MutableCollection<Literal>? {
        val environment = super.perceive()
        val wanted = percepts ?: return environment
        return wanted.perceive(environment, fleet.directory)
    }

    /** Runs the agent until it is stopped. Jason's reasoning cycle catches exceptions, but an error would end the agent's thread. */
    override fun run() = try {
        super.run()
    } catch (@Suppress("TooGenericExceptionCaught") error: Throwable) {
        if (isRunning) failed(error) else throw error
    }

    override fun reasoningCycle() {
        if (mayRun()) super.reasoningCycle() else sleep()
    }

    private fun mayRun() = reign?.isValid() != false

    override fun reasoningCycleFinished() {
        super.reasoningCycleFinished()
        questions.endAllBut(ts.c.pendingIntentions.keys)
        if (reign != null && System.nanoTime() - keptNs >= KEEP_NS) keepMind(reign)
    }

    private fun keepMind(reign: Reign) {
        keptNs = System.nanoTime()
        val mind = Mind.of(ts, MessageContent::write) { left ->
            if (leftOut.add(left)) logger.warning("other computers do not get to know this belief or goal of $agName: $left")
        }
        if (mind == kept && isTold) return
        kept = mind
        isTold = true
        keep(MindNews(agName, reign.term, ++minds, mind.program())).whenComplete { _, lost -> if (lost != null) isTold = false }
    }

    /** Sleeps until [wake] is called, for at most [longestSleepMs]. Unlike in Jason's own class, an earlier call of [wake] counts, too. */
    override fun sleep() {
        if (ts.settings.isSync) return
        sleepLock.withLock {
            try {
                if (!isWoken) woken.await(sleepMs, TimeUnit.MILLISECONDS)
            } catch (_: InterruptedException) {
                // the agent was stopped
            }
            sleepMs = if (isWoken) FIRST_SLEEP_MS else minOf(2 * sleepMs, longestSleepMs)
            isWoken = false
        }
    }

    /**
     * Jason's second, for agents whose environment, other architectures or class may have to be asked for news. The limit also applies to
     * agents whose mind is stored. Other agents are woken by all news, so they cost almost nothing while idle.
     */
    internal val longestSleepMs: Long
        get() {
            val isOnlyWoken = reign == null && firstAgArch === this && envInfraTier == null && ts.ag.javaClass == Agent::class.java
            return if (isOnlyWoken) LONG_SLEEP_MS else SHORT_SLEEP_MS
        }

    override fun wake() = sleepLock.withLock {
        isWoken = true
        woken.signalAll()
    }

    private fun shown(message: Message) = "$message".let { if (it.length > MAX_REASON) "${it.take(MAX_REASON)}…" else it }

    private fun held() = errorOf(Unreachable("$agName does not run here now: most computers of the fleet are out of touch"))

    private companion object {
        /** The interval between copies of the mind of an agent that outlives its computer. A sleeping agent has a cycle each second. */
        const val KEEP_NS = 1_000_000_000L
        const val FIRST_SLEEP_MS = 50L
        const val SHORT_SLEEP_MS = 1000L
        const val LONG_SLEEP_MS = 30_000L

        /** The most characters of a message, or of the reason why a question gets no answer, in an error: contents may be megabytes. */
        const val MAX_REASON = 500
    }
}
