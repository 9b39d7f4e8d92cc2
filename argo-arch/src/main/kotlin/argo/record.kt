package argo

import jason.asSyntax.StringTerm

/**
 * The internal action `argo.record(Why)`: keeps the events that led to this call. With `argo_record="last(Minutes)"` in the `.mas2j`, it
 * writes the last minutes to a file, `recording-….mcap`. With `argo_record="FILE"`, it marks this moment in the file with Why, a string or
 * any term. The agent does not wait for the disk.
 *
 * Fails the plan with `error(not_recording)` if the agent has no recording or it has ended, `error(wrong_arguments)` or `error(not_argo)`.
 */
@Suppress("ClassName")
open class record : BoardInternalAction("argo.record", 1..1) {
    override fun run(call: Call) {
        val why = call.args[0].let { if (it is StringTerm) it.string else "$it" }
        val isKept = call.arch.observers.count { it.recordWanted(why) } > 0
        if (isKept) return
        throw call.failure(
            "not_recording",
            "the agent is not recorded, or no longer, which the log says; [argo_record=\"last(5)\"] in the .mas2j keeps five minutes",
        )
    }
}
