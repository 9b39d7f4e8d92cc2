package samples.collision

import jason.architecture.AgArch
import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.NumberTerm
import jason.asSyntax.PredicateIndicator
import jason.asSyntax.StringTerm

/**
 * Shows other threads the beliefs of an agent that stops a robot. Jason's belief base belongs to the agent's thread. The agent's thread
 * reads the beliefs at the end of each reasoning cycle.
 *
 * @param changed called by the agent's thread at each change of the believed front distance, with the numbers of remaining events and
 * intentions
 */
class Witness(private val changed: (front: Double?, events: Int, intentions: Int) -> Unit = { _, _, _ -> }) : AgArch() {
    /** The beliefs at the end of the last reasoning cycle. Safe for use by several threads. */
    @Volatile
    var beliefs = Beliefs()
        private set

    override fun reasoningCycleFinished() {
        val statuses = all("status", 1).map { it.getTerm(0).toString() }.toList()
        val now = Beliefs(
            distance = all("dist", 2).firstOrNull { it.getTerm(0).toString() == "f" }?.let { (it.getTerm(1) as? NumberTerm)?.solve() },
            status = statuses.find { it == STOPPED } ?: statuses.firstOrNull(),
            trouble = all("trouble", 1).firstOrNull()?.getTerm(0)?.let { if (it is StringTerm) it.string else it.toString() },
            port = all("port", 2).firstOrNull()?.getTerm(1)?.toString(),
        )
        if (now.distance != beliefs.distance) changed(now.distance, ts.c.events.size, ts.c.runningIntentions.size)
        beliefs = now
        super.reasoningCycleFinished()
    }

    private fun all(functor: String, arity: Int): Sequence<Literal> =
        ts.ag.bb.getCandidateBeliefs(PredicateIndicator(functor, arity))?.asSequence().orEmpty()

    /** Makes the agent stop its robot at once, whatever it is doing. Does not wait for the stop. */
    fun haltRobot() {
        ts.runAtBeginOfNextCycle { ts.c.addAchvGoal(ASSyntax.createLiteral("halt"), Intention.EmptyInt) }
        firstAgArch.wakeUpSense()
    }

    /**
     * @property distance the front distance in cm, or null if the agent has perceived none
     * @property status `front` while the robot drives, `stopped` after the agent has stopped it, or null before that
     * @property trouble the reason why the agent cannot continue, or null
     * @property port the state of the agent's port, `on`, `off` or `timeout`, or null if it has no port
     */
    data class Beliefs(
        val distance: Double? = null,
        val status: String? = null,
        val trouble: String? = null,
        val port: String? = null,
    ) {
        val isStopped: Boolean get() = status == STOPPED

        /** True if the agent has started its robot and not stopped it since. */
        val mayDrive: Boolean get() = status != null && !isStopped
    }

    private companion object {
        const val STOPPED = "stopped"
    }
}
