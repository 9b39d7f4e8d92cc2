package argo.recording.replay

import argo.recording.Cycle
import java.time.Duration

/**
 * A command that a plan has sent, with its time.
 *
 * @property cycle Jason's number of the cycle
 * @property ns the beginning of the cycle, in ns of the agent's clock
 * @property port the port of the command's board; null if it is not known
 * @property place the file and the line of the step that sent the command; null if it is not known
 */
data class TimedCommand(val cycle: Int, val ns: Long, val port: String?, val text: String, val place: String?) {
    /** Returns true if [other] has an equal text, and may be for the board of this command. */
    fun isSame(other: TimedCommand): Boolean = text == other.text && (port == null || other.port == null || port == other.port)
}

internal fun Cycle.sent(): List<TimedCommand> = input.calls.flatMap { it.commands }.map { sent ->
    val place = course.step?.run { placeOf(plan.file, line) }
    TimedCommand(number, ns, sent.port, sent.text, place)
}

internal fun placeOf(file: String?, line: Int?): String? = if (file == null || line == null) null else "$file:$line"

/**
 * The first difference between the recorded commands and the commands of the replay.
 *
 * @property recorded the recorded command; null if the agent sends an additional command
 * @property now the command of the replay; null if the recorded command is missing
 * @property same the number of equal commands before the difference
 */
data class CommandDifference(val recorded: TimedCommand?, val now: TimedCommand?, val same: Int) {
    init {
        require(recorded != null || now != null) { "one of both differs" }
    }

    /** The kind of the difference: `other`, `missing`, `additional`, `earlier` or `later`. */
    val kind: String
        get() = when {
            recorded == null -> "additional"
            now == null -> "missing"
            !recorded.isSame(now) -> "other"
            else -> if (now.ns < recorded.ns) "earlier" else "later"
        }

    /** The time of the difference, in ns of the agent's clock. */
    val ns: Long get() = listOfNotNull(recorded?.ns, now?.ns).min()

    companion object {
        /**
         * Returns the first difference between the commands [recorded] and [now], both in the order of their times; null if there is none.
         *
         * @param within the largest difference in time between equal commands
         * @param endNs the end of the recording; later commands of the agent are no differences
         */
        fun first(recorded: List<TimedCommand>, now: List<TimedCommand>, within: Duration, endNs: Long): CommandDifference? {
            val most = within.toNanos()
            fun isSame(one: TimedCommand?, other: TimedCommand?) =
                one != null && other != null && one.isSame(other) && other.ns - one.ns in -most..most
            for (same in 0 until maxOf(recorded.size, now.size)) {
                val one = recorded.getOrNull(same)
                val other = now.getOrNull(same)
                if (one == null && other != null && other.ns > endNs) return null
                if (one == null || other == null) return CommandDifference(one, other, same)
                if (isSame(one, other)) continue
                val lateNs = other.ns - one.ns
                return when {
                    isSame(recorded.getOrNull(same + 1), other) -> CommandDifference(one, null, same)
                    isSame(one, now.getOrNull(same + 1)) -> CommandDifference(null, other, same)
                    one.isSame(other) || lateNs in -most..most -> CommandDifference(one, other, same)
                    lateNs > 0 -> CommandDifference(one, null, same)
                    else -> CommandDifference(null, other, same)
                }
            }
            return null
        }
    }
}
