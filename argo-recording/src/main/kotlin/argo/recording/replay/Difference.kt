package argo.recording.replay

/**
 * Where a replay differs from its recording.
 *
 * @property agent the agent
 * @property cycle Jason's number of the cycle
 * @property ns when the cycle began, in ns of the agent's clock
 * @property what what differs: `event`, `plan`, `step`, `call`, `mail` and others
 * @property recorded what the recording has; null: nothing
 * @property now what came now; null: nothing
 * @property cause the likely cause, in a sentence
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
    /** True if only the project's own action or function gave another result: the recorded one was used, and the agent run on. */
    val isOfResult: Boolean get() = what.startsWith(RESULT)

    override fun toString() =
        "agent $agent, cycle $cycle, $what: recorded ${recorded ?: "nothing"}, now ${now ?: "nothing"}; $cause"

    internal companion object {
        const val RESULT = "result of "
    }
}
