package argo.tools.board

import argo.filters.matching.perceptsOf
import argo.filters.withControlsShown
import javino.PerceptsRequest
import javino.Protocol
import javino.link.BoardListener
import javino.link.Link
import javino.wire.BoardAction
import javino.wire.ReflexOutcome
import java.util.concurrent.TimeUnit

internal interface Description {
    /** Returns the facts in words. The first line names the kind of board. */
    fun lines(): List<String>

    fun members(): Map<String, Any?>
}

/**
 * The known facts about a board on a serial line.
 *
 * @property actions the actions with their numbers of arguments, such as `ledOn` or `speed/1`. A star in place of the number means any
 * number. Null if the board does not describe itself
 * @property described the kinds of percepts in the board's own description
 * @property lost the number of actions of the sketch that do not fit into the board's memory
 * @property rules the number of critical rules that the board can hold, or null for version 1
 */
internal class BoardDescription(
    private val protocol: Protocol,
    private val actions: List<String>?,
    private val lost: Int,
    private val percepts: List<String>,
    private val described: DescribedKinds,
    private val rules: Int?,
) : Description {
    override fun lines(): List<String> = listOf(
        "a Javino board of ${versionSpoken(protocol)}",
        "actions: " + when {
            protocol != Protocol.V2 -> "unknown; a board of version 1 does not describe itself"
            actions == null -> "unknown; the board did not describe them in time"
            actions.isEmpty() -> "unknown; its sketch has no table of actions"
            else -> actions.joinToString()
        } + if (lost == 0) "" else "; $lost more found no room (126 at most, fewer in little memory) and are refused, " +
            "see \"javino.act.full()\" and JavinoSized",
        "percepts: " + percepts.joinToString("; ").ifEmpty { "none now" },
        "kinds of percepts: " + when {
            protocol != Protocol.V2 -> "unknown; a board of version 1 does not describe them"
            described.kinds.isEmpty() -> described.trouble ?: "not described"
            else -> listOfNotNull(described.kinds.joinToString("; "), described.trouble).joinToString("; ")
        },
        "critical rules: " +
            if (rules == null || rules == 0) "none on the board; the computer watches them" else "up to $rules on the board",
    ).map(::withControlsShown)

    override fun members(): Map<String, Any?> = mapOf(
        "board" to "a Javino board of ${versionSpoken(protocol)}",
        "actions" to actions,
        "actionsLost" to lost,
        "percepts" to percepts,
        "kinds" to described.kinds.map { "$it" },
        "kindsMissing" to described.trouble,
        "rules" to rules,
    )

    companion object {
        private const val ANSWER_MS = 1_000

        /** Asks the board on [link] once for its percepts and its description. Throws the exceptions of [Link.request]. */
        fun of(link: Link): BoardDescription {
            val welcome = Welcome()
            link.onBoardEvents(welcome)
            val answer = link.request(PerceptsRequest.ALL, ANSWER_MS).text()
            val actions = actionsOf(link)?.map(::written)
            val described = DescribedKinds.of(link, ANSWER_MS)
            val rules = welcome.rules.takeIf { link.protocol() == Protocol.V2 }
            return BoardDescription(link.protocol(), actions, link.actionsLost(), perceptsOf(answer), described, rules)
        }
    }

    private class Welcome : BoardListener {
        @Volatile
        var rules = 0

        override fun sessionBegan(rules: Int) {
            this.rules = rules
        }

        override fun critical(rule: Int, outcome: ReflexOutcome, percept: String, receivedNanos: Long) = Unit
    }
}

/**
 * Waits up to three seconds for the action list of the board on [link], and returns it. The list is empty if the sketch has no table of
 * actions. The result is null if the board speaks version 1 or sends no list in time. Throws the exceptions of [Link.watch].
 */
internal fun actionsOf(link: Link): List<BoardAction>? {
    val end = System.nanoTime() + VOCABULARY_NANOS
    while (link.protocol() == Protocol.V2 && link.vocabulary().isEmpty && System.nanoTime() - end < 0) link.watch(SLICE_MS)
    return link.vocabulary().orElse(null)
}

private const val SLICE_MS = 20
private val VOCABULARY_NANOS = TimeUnit.SECONDS.toNanos(3)

internal fun written(action: BoardAction) = action.name + when (action.arguments) {
    0 -> ""
    BoardAction.ANY -> "/*"
    else -> "/${action.arguments}"
}
