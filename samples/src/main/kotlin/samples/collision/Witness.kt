package samples.collision

import jason.architecture.AgArch
import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.NumberTerm
import jason.asSyntax.PredicateIndicator
import jason.asSyntax.StringTerm

/**
 * Reads the beliefs of the agent `robot` for other threads. Jason's belief base belongs to the agent's thread, so that thread reads it, at
 * the end of each reasoning cycle.
 */
internal class Witness : AgArch() {
    /** The beliefs at the end of the last reasoning cycle; any thread may ask. */
    @Volatile
    var beliefs = Beliefs()
        private set

    override fun reasoningCycleFinished() {
        beliefs = Beliefs(
            distance = all("dist", 2).firstOrNull { it.getTerm(0).toString() == "f" }?.let { (it.getTerm(1) as? NumberTerm)?.solve() },
            status = all("status", 1).firstOrNull()?.getTerm(0)?.toString(),
            trouble = all("trouble", 1).firstOrNull()?.getTerm(0)?.let { if (it is StringTerm) it.string else it.toString() },
            port = all("port", 2).firstOrNull()?.getTerm(1)?.toString(),
        )
        super.reasoningCycleFinished()
    }

    private fun all(functor: String, arity: Int): Sequence<Literal> =
        ts.ag.bb.getCandidateBeliefs(PredicateIndicator(functor, arity))?.asSequence().orEmpty()

    /** Makes the agent stop its robot, whatever it is doing; returns at once. */
    fun haltRobot() {
        ts.runAtBeginOfNextCycle { ts.c.addAchvGoal(ASSyntax.createLiteral("halt"), Intention.EmptyInt) }
        firstAgArch.wakeUpSense()
    }

    /**
     * @property distance the front distance in cm, null if it has perceived none
     * @property status `front` while it has its robot drive, `stopped` when it has stopped it, null before
     * @property trouble the reason why it cannot go on, null if it can
     * @property port the state of its port: `on`, `off`, `timeout`, or null when it has not asked for one
     */
    data class Beliefs(
        val distance: Double? = null,
        val status: String? = null,
        val trouble: String? = null,
        val port: String? = null,
    )

    companion object {
        /** The belief about its status when it has stopped its robot. */
        const val STOPPED = "stopped"
    }
}
