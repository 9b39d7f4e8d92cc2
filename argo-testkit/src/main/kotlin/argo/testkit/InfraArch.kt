package argo.testkit

import jason.architecture.AgArch
import jason.asSemantics.ActionExec
import jason.asSemantics.Message
import jason.asSyntax.ASSyntax

/** What the infrastructure is for an agent under test: its name, its mail, and what wakes it. It is alone and has no environment. */
internal class InfraArch(private val name: String) : AgArch() {
    private val mail = ArrayDeque<Message>()
    private var awake = true
    private var running = true

    /** What the agent has said to others, in its order. */
    val said = ArrayList<Message>()

    /** Runs one reasoning cycle, unless the agent sleeps. */
    fun step(): Boolean {
        if (!awake && ts.canSleep()) return false
        awake = false
        firstAgArch.incCycleNumber()
        firstAgArch.reasoningCycleStarting()
        ts.reasoningCycle()
        firstAgArch.reasoningCycleFinished()
        return true
    }

    /** Puts [message] into the agent's mailbox. */
    fun receive(message: Message) {
        mail += message
        wake()
    }

    /** Stops the agent as an infrastructure does. */
    fun end() {
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
        if (message.sender == null) message.sender = name
        said += message
        if (message.receiver == name) receive(message)
    }

    override fun broadcast(message: Message) = sendMsg(message.clone().apply { receiver = EVERYBODY })

    override fun act(action: ActionExec) {
        action.result = false
        action.setFailureReason(ASSyntax.createAtom("noenv"), "an agent under test has no environment; argo.act speaks to its board")
        actionExecuted(action)
    }

    companion object {
        /** The receiver of what is broadcast. */
        const val EVERYBODY = "everybody"
    }
}
