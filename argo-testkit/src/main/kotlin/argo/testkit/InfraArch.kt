package argo.testkit

import argo.boundary.Transparent
import jason.architecture.AgArch
import jason.asSemantics.ActionExec
import jason.asSemantics.Message
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Structure
import jason.environment.Environment
import jason.environment.EnvironmentInfraTier
import jason.runtime.RuntimeServices
import jason.runtime.RuntimeServicesFactory

/**
 * The infrastructure of an agent under test. The infrastructure provides a name, a mailbox and an environment, and wakes the agent. [mas]
 * contains the agents with which it exchanges messages.
 */
internal class InfraArch(private val name: String, private val mas: TestMas, private val environment: Environment?) : AgArch() {
    private val mail = ArrayDeque<Message>()
    private var awake = true
    private var running = true

    val said = ArrayList<Message>()

    fun reason(): Boolean {
        if (!running || !awake && ts.canSleep()) return false
        awake = false
        firstAgArch.incCycleNumber()
        firstAgArch.reasoningCycleStarting()
        ts.reasoningCycle()
        firstAgArch.reasoningCycleFinished()
        return true
    }

    fun receive(message: Message) {
        mail += message
        wake()
    }

    /** Stops the agent, as Jason's infrastructure does. Later calls have no effect. */
    fun end() {
        if (!running) return
        running = false
        ts.ag.stopAg()
        firstAgArch.stop()
    }

    override fun getAgName() = name

    override fun isRunning() = running

    override fun canSleep() = mail.isEmpty()

    override fun wake() {
        awake = true
    }

    override fun wakeUpSense() = wake()

    override fun wakeUpDeliberate() = wake()

    override fun wakeUpAct() = wake()

    override fun checkMail() {
        while (true) ts.c.addMsg(mail.removeFirstOrNull() ?: return)
    }

    override fun sendMsg(message: Message) {
        say(message)
        mas.deliver(message)
    }

    override fun broadcast(message: Message) {
        say(message.clone().apply { receiver = EVERYBODY })
        mas.broadcast(message.apply { sender = name })
    }

    private fun say(message: Message) {
        if (message.sender == null) message.sender = name
        said += message.clone()
    }

    override fun perceive(): MutableCollection<Literal>? = environment?.getPercepts(name)

    @Suppress("OVERRIDE_DEPRECATION") // Jason 3.3 still calls this function for some services
    override fun getRuntimeServices(): RuntimeServices = RuntimeServicesFactory.get()

    override fun act(action: ActionExec) {
        action.result = environment?.executeAction(name, action.actionTerm) ?: false
        if (environment == null) action.setFailureReason(ASSyntax.createAtom("noenv"), NO_ENVIRONMENT)
        actionExecuted(action)
    }

    companion object {
        const val EVERYBODY = "everybody"
        private const val NO_ENVIRONMENT =
            "this agent under test has no environment, so it can only do internal actions: " +
                "argo.act speaks to its board, and \"environment = …\" gives it one"
    }
}

internal class EnvironmentTier(private val mas: TestMas) : EnvironmentInfraTier {
    override fun informAgsEnvironmentChanged(vararg agents: String) =
        mas.running().filter { agents.isEmpty() || it.name in agents }.forEach { it.infra.wake() }

    override fun getRuntimeServices(): RuntimeServices = RuntimeServicesFactory.get()

    override fun isRunning(): Boolean = mas.running().isNotEmpty()

    override fun actionExecuted(agent: String, action: Structure, success: Boolean, infraData: Any?) =
        throw UnsupportedOperationException("the outcome of $action is what executeAction returns")
}

/** Counts the cycles in which the agent has perceived something new. A counter is the first architecture of its agent. */
internal class PerceptionCounter : AgArch(), Transparent {
    var perceptions = 0
        private set

    override fun perceive(): MutableCollection<Literal>? = super.perceive().also { if (it != null) perceptions++ }
}
