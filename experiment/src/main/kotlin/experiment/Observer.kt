package experiment

import jason.architecture.AgArch
import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.NumberTerm
import jason.asSyntax.PredicateIndicator
import jason.asSyntax.StringTerm

/**
 * Reads the beliefs of an agent of the experiment for other threads. Jason's belief base belongs to the agent's thread, so that thread
 * reads it, at the end of each reasoning cycle.
 *
 * @param changed is called by the agent's thread for each change of the believed front distance
 */
internal class Observer(private val changed: (front: Double?, events: Int, intentions: Int) -> Unit) : AgArch() {
    private var front: Double? = null

    /** The front distance in cm that the agent believes, null if it believes none. Any thread may read this and the other properties. */
    val believedFront: Double? get() = seenFront

    @Volatile
    private var seenFront: Double? = null

    /** True if the agent believes that it has stopped its robot. */
    @Volatile
    var hasStopped = false
        private set

    /** The reason why the agent cannot go on, null if it can. */
    @Volatile
    var trouble: String? = null
        private set

    override fun reasoningCycleFinished() {
        val now = all("dist").firstOrNull { it.arity == 2 && it.getTerm(0).toString() == "f" }?.let {
            (it.getTerm(1) as? NumberTerm)?.solve()
        }
        if (now != front) changed(now, ts.c.events.size, ts.c.runningIntentions.size)
        front = now
        seenFront = now
        hasStopped = all("status", 1).any { it.getTerm(0).toString() == "stopped" }
        trouble = all("trouble", 1).firstOrNull()?.getTerm(0)?.let { if (it is StringTerm) it.string else it.toString() }
        super.reasoningCycleFinished()
    }

    /** Makes the agent stop its robot, whatever it is doing; returns at once. */
    fun haltRobot() {
        ts.runAtBeginOfNextCycle { ts.c.addAchvGoal(ASSyntax.createLiteral("halt"), Intention.EmptyInt) }
        firstAgArch.wakeUpSense()
    }

    private fun all(functor: String, arity: Int = 2): Sequence<Literal> =
        ts.ag.bb.getCandidateBeliefs(PredicateIndicator(functor, arity))?.asSequence().orEmpty()
}
