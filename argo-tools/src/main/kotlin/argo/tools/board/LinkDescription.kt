package argo.tools.board

import argo.filters.matching.perceptsOf
import argo.filters.withControlsShown
import argo.links.BoardLink
import argo.links.Wish

/** The known facts about a board without a serial line, such as a ROS robot. */
internal class LinkDescription private constructor(scheme: String, actions: List<String>?, percepts: List<String>) : Description {
    private val facts = mapOf("board" to "a board that is reached over $scheme", "actions" to actions, "percepts" to percepts)

    override fun lines(): List<String> = facts.map { (name, value) ->
        val words = (value as? List<*>)?.joinToString("; ")?.ifEmpty { "none now" } ?: "${value ?: "unknown"}"
        withControlsShown(if (name == "board") words else "$name: $words")
    }

    override fun members(): Map<String, Any?> = facts

    companion object {
        private const val LISTENING_MS = 1_500
        private const val INTERVAL_MS = 100
        private const val ANSWER_MS = 1_000

        fun of(link: BoardLink): LinkDescription {
            link.wants(Wish(true, INTERVAL_MS, null))
            val end = System.nanoTime() + LISTENING_MS * 1_000_000L
            var text = ""
            while (System.nanoTime() - end < 0) link.listen(ANSWER_MS)?.let { text = it.text }
            return LinkDescription(link.port.substringBefore(':'), link.actions?.map(::written), perceptsOf(text))
        }
    }
}
