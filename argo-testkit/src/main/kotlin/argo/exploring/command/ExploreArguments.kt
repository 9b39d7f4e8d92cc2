package argo.exploring.command

import argo.exploring.Exploration
import argo.exploring.Fault
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds

/**
 * The arguments of the program: a file and options.
 *
 * @throws IllegalArgumentException if the arguments are wrong
 */
internal class ExploreArguments(arguments: List<String>) {
    val source: String = requireNotNull(arguments.firstOrNull()) { "name the file of an agent or of a system" }

    private val values = arguments.drop(1).groupBy({ nameOf(it) }, { it.substringAfter('=') })

    val boards get() = all("board")
    val isVersion2 get() = "version2" in values
    val described get() = one("boards")
    val messages get() = all("message")
    val rules get() = all("rule")
    val left get() = all("without")
    val spec: Path? get() = one("spec")?.let(Path::of)
    val faults: List<Fault>? get() = one("faults")?.split(',')?.filter { it.isNotBlank() }?.map(::faultOf)
    val seed get() = one("seed")?.toLong()
    val runs get() = one("runs")?.toInt()
    val time get() = one("time")?.toInt()?.seconds

    private fun all(name: String) = values[name].orEmpty()

    private fun one(name: String) = values[name]?.last()

    private fun nameOf(argument: String): String {
        require(argument.startsWith("--")) { "$argument is one argument too many" }
        return argument.removePrefix("--").substringBefore('=').also { require(it in NAMES) { "there is no option --$it" } }
    }

    private fun faultOf(name: String): Fault = requireNotNull(Fault.entries.find { it.name == name.trim().uppercase().replace('-', '_') }) {
        "there is no fault $name; there are ${Fault.entries.joinToString { it.name.lowercase() }}"
    }

    private companion object {
        val NAMES = setOf("board", "version2", "boards", "message", "rule", "without", "spec", "faults", "seed", "runs", "time")
    }
}

internal fun Exploration.describedBy(options: ExploreArguments) {
    options.described?.let { describedIn(it) }
    options.boards.forEach { described(it, options.isVersion2) }
    options.messages.forEach { message(it) }
    options.left.forEach { left -> require(isKnownRule(left)) { noSuchRule(left) } }
    val more = options.rules.map(::ruleOf)
    rules(kept.filterNot { rule -> more.any { it.name == rule.name } || options.left.any { isNamed(rule, it) } } + more)
    options.faults?.let { faults(*it.toTypedArray()) }
    options.seed?.let { seed = it }
    options.runs?.let { runs = it }
    options.time?.let { time = it }
}

/** Adds the message in [text], which consists of agent, sender, performative and content. Only the content may contain blanks. */
private fun Exploration.message(text: String) {
    val words = text.trim().split(Regex("\\s+"), limit = MESSAGE_WORDS)
    require(words.size == MESSAGE_WORDS) {
        "a message is AGENT SENDER PERFORMATIVE CONTENT, as \"robot boss achieve patrol(3)\", not \"$text\""
    }
    val (agent, sender, performative, content) = words
    message(agent, sender, performative, content)
}

private const val MESSAGE_WORDS = 4
