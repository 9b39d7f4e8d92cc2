package argo.recording.why

import argo.recording.replay.RecordingException
import kotlinx.serialization.Serializable
import kotlinx.serialization.Transient
import kotlin.math.abs

/**
 * A command of an agent in a recording.
 *
 * @property number counts the commands of the agent, from 1
 * @property text the command, such as `speed(120)`, or the action of the environment
 * @property port the port of the command's board; null if it was an action of the environment
 * @property seconds the beginning of the step's cycle, or the time of the board's report of a reflex, in seconds since the first cycle
 * @property cycle Jason's number of the last cycle that had begun by [seconds], see [argo.recording.Cycle.number]; 0 if none had begun
 * @property sent the command's number among the agent's commands to boards, from 1, as in the live view and the timeline. The property is
 * null for an action of the environment, and for a reflex that the board carried out.
 * @property index counts the recorded cycles up to the cycle of the command, see [argo.recording.Cycle.index]
 */
@Serializable
data class RecordedCommand(
    val agent: String,
    val number: Int,
    val text: String,
    val port: String? = null,
    val seconds: Double,
    val cycle: Int,
    val by: Sender = Sender.PLAN,
    val sent: Long? = null,
    @Transient
    internal val index: Long = 0,
)

/** The sender of a command. */
enum class Sender {
    /** A step of a plan. */
    PLAN,

    /** A critical rule of a filter. */
    REFLEX,

    /** A user or another program, for example through the live view. */
    OUTSIDE,
}

/**
 * A question about a command, with the properties by which the command is found.
 *
 * @property text the whole command, or its functor; empty for any command
 * @property seconds the approximate time since the first cycle; null for any time
 * @property count the number of the command, from 1, among the commands with this [text]. If [text] is empty, the number is
 * [RecordedCommand.sent]. If [count] is null, the question is about the command nearest to [seconds] or, without [seconds], about the last
 * command.
 */
data class Question(val text: String, val seconds: Double? = null, val count: Int? = null) {
    override fun toString() = text + (seconds?.let { "@${it}s" } ?: count?.let { "#$it" }.orEmpty())

    /** Returns true if the question is about [command], at any time. */
    fun isAbout(command: String): Boolean = command == text || command.substringBefore('(') == text

    /**
     * Returns the command of [all] that the question is about.
     *
     * @throws RecordingException if there is none, or if several agents have the command; the message names other commands or the agents
     */
    fun find(all: List<RecordedCommand>): RecordedCommand {
        val fitting = all.filter { isAbout(it.text) }
        val found = when {
            text.isEmpty() -> all.filter { it.sent == count?.toLong() }.also(::requireOneAgent).firstOrNull()
            count != null -> fitting.getOrNull(count - 1)
            seconds != null -> fitting.minByOrNull { abs(it.seconds - seconds) }?.takeIf { abs(it.seconds - seconds) <= TOLERANCE_S }
            else -> fitting.lastOrNull()
        }
        return found ?: throw RecordingException(notFound(all, fitting.size))
    }

    private fun requireOneAgent(found: List<RecordedCommand>) {
        if (found.size < 2) return
        throw RecordingException("several agents have a command $this: ${found.joinToString { it.agent }}; --of names one of them")
    }

    private fun notFound(all: List<RecordedCommand>, fitting: Int): String {
        if (all.isEmpty()) return "the recording holds no command"
        val what = if (count != null && fitting > 0) "the last command $text is number $fitting" else "there is no command $this"
        val near = seconds?.let { at -> all.sortedBy { abs(it.seconds - at) }.take(SHOWN).sortedBy { it.seconds } } ?: all.takeLast(SHOWN)
        val shown = near.joinToString { "%s@%.3fs".format(it.text, it.seconds) }
        return "$what; those ${if (seconds == null) "at the end" else "around that time"}: $shown"
    }

    companion object {
        /** The largest difference between the times of a question and of its command, in s. */
        const val TOLERANCE_S = 0.5
        private const val SHOWN = 8
        private val AT = Regex("""(.+?)@(\d{1,9}(?:\.\d{1,9})?)\s*s?""")
        private val COUNTED = Regex("""(.*)#([1-9]\d{0,8})""")

        /** Returns the question in [text]: `stop@12.3s`, `stop#3`, `#17`, `stop`; null if the text is empty. */
        fun of(text: String): Question? {
            val asked = text.trim()
            AT.matchEntire(asked)?.destructured?.let { (command, seconds) -> return Question(command.trim(), seconds.toDouble()) }
            COUNTED.matchEntire(asked)?.destructured?.let { (command, count) -> return Question(command.trim(), count = count.toInt()) }
            return if (asked.isEmpty()) null else Question(asked)
        }
    }
}
