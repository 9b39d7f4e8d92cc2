package argo.tools.board

import javino.PerceptDescription
import javino.PerceptKind
import javino.PortTimeoutException
import javino.link.Link

/**
 * The answer of a board that was asked for its kinds of percepts. [description] is empty if the board describes no kinds. [description] is
 * null if a version 2 board gave no answer in time.
 */
internal class DescribedKinds(val description: PerceptDescription?) {
    val kinds: List<PerceptKind> get() = description?.kinds().orEmpty()

    /** The reason why some kinds are missing, or null if all are there. */
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
        /** The kinds of a board that was not asked: none. */
        val NONE = DescribedKinds(PerceptDescription(emptyList(), emptyList()))

        fun of(link: Link, timeoutMs: Int): DescribedKinds = DescribedKinds(
            try {
                link.perceptDescription(timeoutMs)
            } catch (_: PortTimeoutException) {
                null
            },
        )
    }
}
