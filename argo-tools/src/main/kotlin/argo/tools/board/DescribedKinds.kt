package argo.tools.board

import javino.PerceptDescription
import javino.PerceptKind
import javino.PortTimeoutException
import javino.link.Link

/**
 * A board's answer when asked for the kinds of its percepts. [description] is empty if the board describes no kinds, and null if a board of
 * version 2 gave no answer in time.
 */
internal class DescribedKinds(val description: PerceptDescription?) {
    val kinds: List<PerceptKind> get() = description?.kinds().orEmpty()

    /** The reason why some of the board's kinds are missing, in words; null: all are there. */
    val trouble: String?
        get() {
            val problems = (description ?: return "unknown; the board did not describe them in time").problems()
            return when {
                problems.isEmpty() -> null
                kinds.isEmpty() -> "none of the ${problems.size} that the board describes can be read: ${problems.first()}"
                else -> "${problems.size} more are left out: ${problems.first()}"
            }
        }

    companion object {
        /** For a board that was not asked: no kinds. */
        val NONE = DescribedKinds(PerceptDescription(emptyList(), emptyList()))

        /** Asks the board on [link], and waits [timeoutMs] ms at most. */
        fun of(link: Link, timeoutMs: Int): DescribedKinds = DescribedKinds(
            try {
                link.perceptDescription(timeoutMs)
            } catch (_: PortTimeoutException) {
                null
            },
        )
    }
}
