package argo.exploring

/**
 * Writes a Kotest spec for the shortened run of [found]. The spec fails while the agent breaks the rule. The spec needs a project with the
 * test kit and with the agent in its folders.
 */
fun specOf(found: Found): String {
    val name = found.scenario.name.split(Regex("\\W|_")).joinToString("") { it.replaceFirstChar(Char::uppercase) }
    val rule = found.rule.split(Regex("\\W+")).joinToString("") { it.replaceFirstChar(Char::uppercase) }
    val events = found.events.joinToString("") { "            ${it.form.kotlin},\n" }
    val described = found.scenario.exploration.describedBy?.takeIf { '.' in it }?.let { "\nimport $it" }.orEmpty()
    return """
import argo.exploring.*
import argo.testkit.*
import io.kotest.core.spec.style.FunSpec
import kotlin.time.Duration.Companion.milliseconds$described

class $name${rule}Spec : FunSpec({
    // ${found.breach.how.lineSequence().first()}
    test(${kotlinOf("${found.scenario.name} ${found.rule}")}) {
        shouldKeepRules(
            ${kotlinOf(found.scenario.file)},
$events        ) {
${descriptionOf(found).prependIndent("            ")}
        }
    }
})
""".trimStart()
}

/** Writes the exploration in Kotlin. If its description contains code, writes a call of the function that describes it. */
private fun descriptionOf(found: Found): String {
    val exploration = found.scenario.exploration
    val broken = exploration.kept.first { it.name == found.rule }
    val isCode = exploration.setUps.isNotEmpty() || exploration.boards.values.any { it.scripts.isNotEmpty() } || broken !is ReadyRule
    val function = exploration.describedBy?.let { "${it.substringAfterLast('.')}()" }
    if (isCode) return function ?: "boards() // the function that describes what was explored"
    val settling = "settling = ${kotlinOf(exploration.settling)}"
    return (listOf(settling) + exploration.boards.map { (port, board) -> boardText(port, board) } + "rules($broken)").joinToString("\n")
}

private fun boardText(port: String, board: ExploredBoard): String {
    val sensors = board.sensors.map { sensor ->
        if (sensor.range == null) "sensor(${sensor.percepts.joinToString(transform = ::kotlinOf)})"
        else "sensor(${kotlinOf(sensor.name)}, ${sensor.range}, first = ${sensor.range.first + sensor.first})"
    }
    val known = board.known?.joinToString(transform = ::kotlinOf)
    val version = if (known != null) "knows($known)" else "version2()".takeIf { board.isVersion2 }
    val lines = sensors + listOfNotNull(version)
    return "board(${kotlinOf(port)})" + if (lines.isEmpty()) "" else lines.joinToString("\n", " {\n", "\n}") { "    $it" }
}
