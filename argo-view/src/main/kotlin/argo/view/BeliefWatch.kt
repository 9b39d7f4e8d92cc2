package argo.view

import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.bb.BeliefBase
import java.util.concurrent.TimeUnit
import java.util.logging.Logger

/**
 * Pictures of an agent's belief base, taken by the agent's own thread between two reasoning cycles, while somebody looks, and ten
 * times a second at most.
 *
 * @param beliefs what the agent believes; asked by its thread only
 * @param nanos a clock in ns that never goes back
 */
internal class BeliefWatch(private val beliefs: () -> BeliefBase, private val log: Logger, private val nanos: () -> Long) {
    /** Whether somebody looks. */
    @Volatile
    var isWatched = false
        set(value) {
            if (value && !field) missed = true
            field = value
        }

    /** The newest picture; null: there is none yet. */
    @Volatile
    var newest: Picture? = null
        private set

    @Volatile
    private var missed = false

    @Volatile
    private var lookedNanos: Long? = null
    private var hasFailed = false

    /** Takes a picture if one is wanted. Called by the agent's thread. */
    fun cycleFinished() {
        if (!isWatched) return
        if (isTooEarly()) {
            missed = true
        } else {
            missed = false
            lookedNanos = nanos()
            newest = picture() ?: newest
        }
    }

    /** Whether a cycle has come to its end of which there should be a picture by now: the agent may be sleeping. */
    fun isBehind(): Boolean = isWatched && missed && !isTooEarly()

    private fun isTooEarly() = lookedNanos?.let { nanos() - it < INTERVAL_NANOS } == true

    private fun picture(): Picture? = try {
        val base = beliefs()
        val perceived = base.percepts.asSequence().take(MAX_OF_A_KIND)
        val (hidden, others) = base.asSequence().take(MAX_LOOKED_AT).filterNot { it.hasSource(BeliefBase.APercept) }
            .partition { it.hasAnnot(HIDDEN) }
        Picture(nanos(), base.size() - hidden.size, (others.take(MAX_OF_A_KIND) + perceived).map(::belief))
    } catch (changed: RuntimeException) { // a belief base of the project's own, or one that another thread changes: its agent must go on
        if (!hasFailed) log.warning("the live view cannot read the belief base: $changed")
        hasFailed = true
        null
    }

    private fun belief(literal: Literal): Belief {
        val sources = literal.sources.map { "$it" }
        val bare = literal.copy().apply { delSources() }
        return Belief(shown("$bare"), sources)
    }

    /** What the agent believed at [nanos]: [total] beliefs in all, without those that Jason hides itself. */
    class Picture(val nanos: Long, val total: Int, val beliefs: List<Belief>)

    companion object {
        /** The least time between two pictures, in ns. */
        val INTERVAL_NANOS: Long = TimeUnit.MILLISECONDS.toNanos(100)
        private val HIDDEN = ASSyntax.createAtom("hide_in_mind_inspector") // Jason's own rules
        private const val MAX_OF_A_KIND = 150
        private const val MAX_LOOKED_AT = 5000
    }
}
