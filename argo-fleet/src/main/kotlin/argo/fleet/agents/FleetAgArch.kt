package argo.fleet.agents

import argo.fleet.cluster.Refused
import argo.fleet.cluster.Unreachable
import argo.fleet.node.Directory
import argo.fleet.node.Fleet
import argo.fleet.node.MindNews
import argo.fleet.node.Place
import argo.fleet.node.Reign
import argo.fleet.node.Say
import argo.fleet.node.unreachable
import argo.recording.agent.MessageContent
import jason.JasonException
import jason.architecture.AgArch
import jason.asSemantics.Message
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.infra.local.LocalAgArch
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The infrastructure of an agent in a [Fleet]: the last of its architectures. Its messages go to agents of other computers, too.
 *
 * @param reign the time during which an agent that outlives its computer runs here; null: the agent is not one of these
 * @param keep takes the mind of such an agent
 */
internal class FleetAgArch(
    private val fleet: Fleet,
    private val reign: Reign? = null,
    private val keep: (MindNews) -> Unit = {},
) : LocalAgArch() {
    private val asks = ConcurrentHashMap<Pair<String, String>, String>() // questions under way: message, agent asked; its computer
    private val sleepLock = ReentrantLock()
    private val woken = sleepLock.newCondition()
    private var isWoken = false
    private var sleepMs = FIRST_SLEEP_MS
    private var kept: Mind? = null
    private val leftOut = HashSet<String>()
    private var keptNs = 0L
    private var minds = 0L

    @Volatile
    private var isTold = false // whether all computers that may run the agent have its mind

    @Volatile
    private var percepts: FleetPercepts? = null

    /** Jason calls this after it has read the agent's program, and before it makes other architectures. */
    override fun insertAgArch(arch: AgArch) {
        super.insertAgArch(arch)
        if (arch !== this) return
        FleetActions.install(ts.ag)
        percepts = FleetPercepts.of(ts.settings.getUserParameter(FleetPercepts.OPTION), logger::severe)
    }

    override fun sendMsg(message: Message) {
        if (message.sender == null) message.sender = agName
        if (!mayRun()) throw held()
        val directory = fleet.directory
        when (val place = directory.find(message.receiver)) {
            Place.Here -> super.sendMsg(message)
            is Place.There -> send(message, place.computer)
            is Place.Off -> throw errorOf(unreachable(message.receiver, place, directory.inTouch))
            Place.Unknown -> if (isRunning) throw noAgent("there is no agent ${message.receiver} in the fleet; the message is $message")
        }
    }

    private fun send(message: Message, computer: String) {
        val content = try {
            MessageContent.write(message.propCont)
        } catch (refused: IllegalArgumentException) {
            throw JasonException("$message cannot go to another computer: ${refused.message}", ASSyntax.createAtom("not_sendable"))
        }
        if (message.isAsk && message.msgId.startsWith(Message.msgIdSyncAskPrefix)) asks[message.msgId to message.receiver] = computer
        val said = Say(message.msgId, message.inReplyTo, message.ilForce, message.sender, message.receiver, content, reign?.term ?: 0)
        Deliveries.add(Delivery(message.msgId, message.receiver, fleet.send(computer, said)), logger)
    }

    /** Sends [message] to all other agents. If sending fails for some agents, the others still get [message]. */
    override fun broadcast(message: Message) {
        val failures = (fleet.directory.names - agName).mapNotNull { receiver ->
            try {
                firstAgArch.sendMsg(message.clone().apply { this.receiver = receiver })
                null
            } catch (failed: JasonException) {
                failed
            }
        }
        failures.firstOrNull()?.let { throw it }
    }

    /** Takes [message], which an agent of another computer has sent. Any thread. @throws Refused if its content cannot be read */
    fun take(message: Say) {
        val content = try {
            MessageContent.read(message.content, ts.ag)
        } catch (unreadable: IllegalArgumentException) {
            refuse(message, "${unreadable.message}")
        } catch (_: StackOverflowError) {
            refuse(message, "it is nested too deep")
        }
        if (content is Literal && !content.isGround) content.makeVarsAnnon() // the variables' names belong to the sender
        receiveMsg(
            Message(message.force, message.from, message.to, content, message.id).apply { inReplyTo = message.inReplyTo },
        )
    }

    private fun refuse(message: Say, reason: String): Nothing {
        logger.warning("a message of ${message.from} cannot be read and is refused: $reason")
        throw Refused("${message.to} cannot read the message: $reason")
    }

    override fun receiveMsg(message: Message) {
        message.inReplyTo?.let { asks.remove(it to message.sender) }
        super.receiveMsg(message)
    }

    /** Fails intentions that wait for an answer from a computer that is off now. Wakes an agent that perceives the fleet. Any thread. */
    fun directoryChanged(now: Directory) {
        asks.filterValues { it !in now.inTouch }.forEach { (question, computer) ->
            asks.remove(question)
            val (id, asked) = question
            DeliveryWait.fail(ts, id, Unreachable("$asked has not answered, and its computer $computer is off"))
        }
        isTold = false
        if (percepts != null) wake()
    }

    override fun perceive(): MutableCollection<Literal>? {
        val environment = super.perceive()
        val wanted = percepts ?: return environment
        return wanted.perceive(environment, fleet.directory)
    }

    override fun reasoningCycle() {
        if (mayRun()) super.reasoningCycle() else sleep()
    }

    private fun mayRun() = reign?.isValid() != false

    override fun reasoningCycleFinished() {
        super.reasoningCycleFinished()
        if (reign != null && System.nanoTime() - keptNs >= KEEP_NS) keepMind(reign)
    }

    private fun keepMind(reign: Reign) {
        keptNs = System.nanoTime()
        val mind = Mind.of(ts) { left ->
            if (leftOut.add(left)) logger.warning("other computers do not get to know this belief or goal of $agName: $left")
        }
        if (mind == kept && isTold) return
        kept = mind
        isTold = true
        keep(MindNews(agName, reign.term, ++minds, mind.program()))
    }

    /** Sleeps until [wake] is called, a second at most. Unlike in Jason's own class, a call of [wake] before [sleep] counts too. */
    override fun sleep() {
        if (ts.settings.isSync) return
        sleepLock.withLock {
            try {
                if (!isWoken) woken.await(sleepMs, TimeUnit.MILLISECONDS)
            } catch (_: InterruptedException) {
                // the agent is stopped
            }
            sleepMs = if (isWoken) FIRST_SLEEP_MS else minOf(sleepMs + SLEEP_STEP_MS, LAST_SLEEP_MS)
            isWoken = false
        }
    }

    override fun wake() = sleepLock.withLock {
        isWoken = true
        woken.signalAll()
    }

    private fun held() =
        JasonException("$agName does not run here now: most computers of the fleet are out of touch", ASSyntax.createAtom("unreachable"))

    private companion object {
        /** The time between two copies of the mind of an agent that outlives its computer. A sleeping agent has a cycle each second. */
        const val KEEP_NS = 1_000_000_000L
        const val FIRST_SLEEP_MS = 50L
        const val SLEEP_STEP_MS = 100L
        const val LAST_SLEEP_MS = 1000L
    }
}
