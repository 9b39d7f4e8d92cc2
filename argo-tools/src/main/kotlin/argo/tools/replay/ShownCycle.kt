package argo.tools.replay

import argo.recording.Cycle
import argo.tools.command.jsonOf
import kotlinx.serialization.json.JsonObject

internal class ShownCycle(private val agent: String, val cycle: Cycle) {
    private val commands = cycle.input.calls.flatMap { it.commands }

    fun words(): String = cycle.course.run {
        val words = listOfNotNull(
            event?.let { "event $it" },
            plan?.let { "plan ${it.label} (${it.file}:${it.line})" },
            step?.let { "step ${it.text ?: "end of the plan"} (${it.plan.file}:${it.line ?: it.plan.line})" },
            action?.let { "action $it" },
        ) + commands.map { "sends ${it.text} to ${it.port}" } + mail.map { "${it.performative}(${it.receiver},${it.content})" } +
            printed.map { "prints \"$it\"" }
        "$agent, cycle ${cycle.number}: ${words.joinToString().ifEmpty { "only input" }}"
    }

    /** Returns the events of the cycle as JSON. [seconds] is the time of the cycle after the first one. */
    fun json(seconds: Double): JsonObject = cycle.course.run {
        jsonOf(
            "agent" to agent, "cycle" to cycle.number, "seconds" to seconds, "event" to event,
            "plan" to plan?.let { jsonOf("label" to it.label, "file" to it.file, "line" to it.line) },
            "step" to step?.let { jsonOf("text" to it.text, "file" to it.plan.file, "line" to (it.line ?: it.plan.line)) },
            "action" to action, "commands" to commands.map { jsonOf("port" to it.port, "text" to it.text) },
            "mail" to mail.map { "${it.performative}(${it.receiver},${it.content})" }, "printed" to printed,
        )
    }
}
