package argo.tools.board

import argo.filters.matching.OWN_BELIEFS
import argo.filters.matching.perceptsOf
import argo.filters.matching.whyUnreadable
import argo.filters.withControlsShown
import argo.tools.command.counted
import javino.PerceptKind
import javino.PerceptTerm
import javino.PortException
import javino.PortInterruptedException
import javino.PortTimeoutException
import java.util.concurrent.TimeUnit

/**
 * Observes a board's percepts for [seconds], starting at the creation of this object. [mayBeSilent] is true for a board that sends only
 * changes.
 */
internal class Observation(private val seconds: Int, private val mayBeSilent: Boolean) {
    private val observed = ObservedKinds()
    private val unreadable = LinkedHashSet<String>() // at most MAX_TEXTS
    private val begun = System.nanoTime()
    private val own = LinkedHashSet<String>()
    private var heard = begun
    private var end: String? = null

    var isLost = false
        private set

    /**
     * Observes the message [first] and then the messages that [next] returns. Ends early if the port is lost or if the thread is
     * interrupted.
     */
    fun run(first: String, next: () -> String) {
        add(first)
        try {
            while (System.nanoTime() - begun < TimeUnit.SECONDS.toNanos(seconds.toLong())) takeNext(next)
        } catch (_: PortInterruptedException) {
            end = "it was interrupted after ${heardSeconds()} s"
        } catch (trouble: PortException) {
            isLost = true
            end = "the board was heard for ${heardSeconds()} s only: ${trouble.message}"
        }
    }

    private fun takeNext(next: () -> String) {
        try {
            add(next())
            end = null
        } catch (_: PortTimeoutException) {
            if (!mayBeSilent) end = "the board was heard for ${heardSeconds()} s only, and then gave no answer"
        }
    }

    private fun heardSeconds() = Rates.seconds(TimeUnit.NANOSECONDS.toMillis(heard - begun))

    /** Observes the percepts in [text]. [text] is a message or one percept. */
    fun add(text: String) {
        heard = System.nanoTime()
        for (percept in perceptsOf(text)) {
            val kind = PerceptTerm.of(percept).indicator()
            when {
                whyUnreadable(percept) != null -> if (unreadable.size < MAX_TEXTS) unreadable += percept
                kind in OWN_BELIEFS -> own += kind
                else -> observed.add(percept)
            }
        }
    }

    fun kinds(): List<PerceptKind> = observed.kinds()

    /** Returns a sentence for each reason why the kinds are incomplete. */
    fun notes(): List<String> = listOfNotNull(
        end,
        unreadable.firstOrNull()?.let {
            val number = counted(unreadable.size, "percept") + if (unreadable.size == MAX_TEXTS) " or more" else ""
            "$number left out, which no agent can read, as ${withControlsShown(it)}: ${withControlsShown(whyUnreadable(it).orEmpty())}"
        },
        ownLeftOut(own),
        if (observed.others == 0L) null else "${counted(observed.others, "percept")} of further kinds left out",
    )

    private companion object {
        const val MAX_TEXTS = 1_000
    }
}

/** Returns a sentence about the omitted kinds [own], such as `port/2`, or null if [own] is empty. */
internal fun ownLeftOut(own: Collection<String>): String? =
    if (own.isEmpty()) null else "left out: ${own.distinct().joinToString()}, of beliefs of ARGO's own, which no board can claim"
