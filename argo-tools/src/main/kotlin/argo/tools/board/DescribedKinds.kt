package argo.tools.board

import javino.PerceptDescription
import javino.PerceptKind
import javino.PortTimeoutException
import javino.link.Link

/**
 * A board's answer to the question for the kinds of its percepts. [description] is the answer, empty if the board describes none; null: a
 * board of version 2 gave no answer in time.
 */
internal class DescribedKinds(val description: PerceptDescription?) {
    val kinds: List<PerceptKind> get() = description?.kinds().orEmpty()

    /** The reason why some of the board's kinds are missing, in words; null: none are missing. */
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
        /** The answer of a board that nobody has asked. */
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
