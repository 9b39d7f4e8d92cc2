package argo.resuming

import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import argo.mind.Mind
import java.time.Instant
import java.time.ZoneId
import java.time.format.DateTimeFormatter

/**
 * The state of an agent. The agent's next run continues from this state.
 *
 * @property writtenMs the time of the state, in ms since 1970
 * @property setUp the calls of internal actions that set up the agent's boards, without the prefix `argo.`
 * @property program the initial beliefs and goals of the agent's program
 * @property mind the agent's beliefs and the events of its intentions
 */
internal data class State(
    val agent: String,
    val writtenMs: Long,
    val setUp: List<String>,
    val program: Mind,
    val mind: Mind,
) {
    /** The state as the text of a file in AgentSpeak's notation, which [of] reads. */
    fun text(): String = buildString {
        appendLine("// The state of agent $agent at ${TIME.format(Instant.ofEpochMilli(writtenMs))}, which argo_resume has it go on from.")
        appendLine("// Without this file the agent begins as its program says.")
        appendLine("$WRITTEN$writtenMs).")
        setUp.forEach { appendLine("$ARGO$it.") }
        appendLine("\n// What the program began with.")
        program.program().lineSequence().filter { it.isNotEmpty() }.forEach { appendLine("$PROGRAM${it.removeSuffix(".")}).") }
        appendLine("\n// Beliefs, and the events with which intentions begin anew.")
        appendLine(mind.program())
        appendLine(END)
    }

    companion object {
        private const val ARGO = "argo."
        private const val WRITTEN = "${ARGO}written("
        private const val PROGRAM = "${ARGO}program("
        private const val END = "// The end of the state."
        private val TIME = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss").withZone(ZoneId.systemDefault())

        /**
         * Returns the state of [agent] in [text], a text from [State.text].
         *
         * @throws UnreadableStateException if [text] is cut off, or a line of it cannot be read
         */
        fun of(agent: String, text: String): State {
            val lines = text.lines().map { it.trim() }
            if (lines.lastOrNull { it.isNotEmpty() } != END) throw UnreadableStateException("it is cut off: its last line is not \"$END\"")
            val facts = lines.withIndex().filterNot { (_, line) -> line.isEmpty() || line.startsWith("//") }
                .map { (index, line) -> fact(index + 1, line) }
            val (calls, mind) = facts.partition { it.startsWith(ARGO) }
            val (program, others) = calls.partition { it.startsWith(PROGRAM) }
            val (written, setUp) = others.partition { it.startsWith(WRITTEN) }
            val ms = written.singleOrNull()?.let(::argumentOf)?.toLongOrNull()
                ?: throw UnreadableStateException("it has no line ${WRITTEN}Ms).")
            return State(agent, ms, setUp.map { it.removePrefix(ARGO) }, Mind.of(program.map(::argumentOf)), Mind.of(mind))
        }

        private fun argumentOf(call: String) = call.substringAfter('(').removeSuffix(")")

        /** Returns the fact in [line], without its full stop. Errors name the line by its [number], from 1. */
        private fun fact(number: Int, line: String): String {
            if (!line.endsWith(".")) throw UnreadableStateException("line $number does not end with a full stop: $line")
            val fact = line.dropLast(1)
            val literal = if (fact.startsWith(PROGRAM)) argumentOf(fact) else fact.removePrefix(ARGO)
            try {
                PerceptReader.read(literal.removePrefix("!").removePrefix("+"))
            } catch (wrong: PerceptSyntaxException) {
                throw UnreadableStateException("line $number: ${wrong.message}")
            }
            return fact
        }
    }
}

/** Reports that a text is no state of an agent. [message] says why. */
internal class UnreadableStateException(override val message: String) : Exception(message)
