package argo.recording.replay

import argo.recording.Course
import argo.recording.Cycle
import argo.recording.Mail
import argo.recording.Place
import argo.recording.Step

/**
 * A difference between a replay and its recording.
 *
 * @property cycle Jason's number of the cycle
 * @property ns the beginning of the cycle, in ns of the agent's clock
 * @property what the kind of the difference: `event`, `plan`, `step`, `call`, `mail` and others
 * @property recorded the recorded value; null if there is none
 * @property now the value in the replay; null if there is none
 */
data class Difference(
    val agent: String,
    val cycle: Int,
    val ns: Long,
    val what: String,
    val recorded: String?,
    val now: String?,
    val cause: String,
) {
    /** True if only the result of the project's action or function differs. The replay then used the recorded result and continued. */
    val isOfResult: Boolean get() = what.startsWith(RESULT)

    /** The difference in words, without the agent. */
    internal val words get() = "cycle $cycle, $what: recorded ${recorded ?: "nothing"}, now ${now ?: "nothing"}; $cause"

    override fun toString() = "agent $agent, $words"

    internal companion object {
        const val RESULT = "result of "
    }
}

/** Returns the kind and both values of the first difference between [recorded] and [now]; null if there is none. */
internal fun difference(recorded: Course, now: Course): Triple<String, String?, String?>? {
    if (recorded == now) return null // most cycles
    fun <T> differing(what: String, of: Course.() -> T?): Triple<String, String?, String?>? {
        val (before, after) = recorded.of() to now.of()
        return if (before == after) null else Triple(what, before?.toString(), after?.toString())
    }
    return differing("event") { event?.let(::normal) }
        ?: differing("plan") { plan?.let(::described) }
        ?: differing("step") { step?.let(::described) }
        ?: differing("action") { action?.let(::normal) }
        ?: differing("messages to other agents") { mail.map(::described).takeIf { it.isNotEmpty() } }
        ?: differing("printed lines") { printed.map(::normal).takeIf { it.isNotEmpty() } }
        ?: differing("number of beliefs") { beliefs }
}

/**
 * Returns the comparable part of this replayed course of [cycle]. If the recording lacks parts, because the agent or Java was ending, the
 * result also lacks them. If [isChecking] is false, the project's own actions do not run, and their printed lines come from the recording.
 */
internal fun Course.asFarAs(cycle: Cycle, isChecking: Boolean): Course = when {
    cycle.isEnding -> asFarAs(cycle.course)
    !isChecking && cycle.input.calls.any { it.isOfProject } && isWithin(printed, cycle.course.printed) ->
        copy(printed = cycle.course.printed)
    cycle.missesPrints -> copy(printed = printed.take(cycle.course.printed.size))
    else -> this
}

private fun Course.asFarAs(recorded: Course) = copy(
    event = event.takeIf { recorded.event != null },
    plan = plan.takeIf { recorded.plan != null },
    step = step.takeIf { recorded.step != null },
    action = action.takeIf { recorded.action != null },
    mail = mail.take(recorded.mail.size),
    printed = printed.take(recorded.printed.size),
    beliefs = recorded.beliefs,
)

private fun isWithin(lines: List<String>, all: List<String>): Boolean =
    all.iterator().let { rest -> lines.all { line -> rest.asSequence().any { normal(it) == normal(line) } } }

private fun described(place: Place) = normal("@${place.label} (${place.file}:${place.line})")

private fun described(step: Step) =
    "${step.text?.let(::normal) ?: "end of the plan"} of intention ${step.intention} (${step.plan.file}:${step.line ?: step.plan.line})"

private fun described(mail: Mail) = normal("${mail.performative}(${mail.receiver},${mail.content})")

/**
 * Returns [text] without the numbers, places and hashes that do not depend on the agent. Jason numbers the variables, plans and messages of
 * all agents. The place of failed code is a path on the machine of the recording, and is missing in messages. A hash belongs to a Java
 * object, such as the iterator in the steps of a loop.
 */
internal fun normal(text: String): String { // called for each part of each cycle, so it searches only where it may find something
    var left = text
    if ('_' in left || "mid" in left) left = left.replace(NUMBERED, "$1")
    if ("code_" in left) left = left.replace(CODE_PLACE, "$1")
    if ('@' in left) left = left.replace(OBJECT, "$1")
    return left
}

private val NUMBERED = Regex("""\b(_|p__|mid|samid)\d+(?:_\d+)*""")
private val CODE_PLACE = Regex("""\b(code_line|code_src)\((?:no_code|\d+|"(?:[^"\\]|\\.)*")\)""")
private val OBJECT = Regex("""\b((?:\w+\.)+[\w$]+)@[0-9a-f]{1,8}\b""")
