package argo.recording.replay

/**
 * A difference between a replay and its recording.
 *
 * @property agent the agent
 * @property cycle Jason's number of the cycle
 * @property ns the beginning of the cycle, in ns of the agent's clock
 * @property what the kind of the difference: `event`, `plan`, `step`, `call`, `mail` and others
 * @property recorded the recorded value; null: none
 * @property now the value in the replay; null: none
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
    /** True if only an action or function of the project gave another result: then the replay used the recorded result, and went on. */
    val isOfResult: Boolean get() = what.startsWith(RESULT)

    override fun toString() =
        "agent $agent, cycle $cycle, $what: recorded ${recorded ?: "nothing"}, now ${now ?: "nothing"}; $cause"

    internal companion object {
        const val RESULT = "result of "
    }
}
