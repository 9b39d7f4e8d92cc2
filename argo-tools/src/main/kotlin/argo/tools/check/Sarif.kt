package argo.tools.check

import argo.check.findings.Finding
import argo.check.findings.Level
import argo.tools.command.jsonArrayOf
import argo.tools.command.jsonOf
import kotlinx.serialization.json.JsonObject
import java.net.URI
import java.nio.file.Path

/** Writes [findings] in SARIF 2.1.0, the Static Analysis Results Interchange Format of OASIS. */
internal fun sarifOf(findings: List<Finding>): JsonObject = jsonOf(
    "\$schema" to "https://json.schemastore.org/sarif-2.1.0.json",
    "version" to "2.1.0",
    "runs" to jsonArrayOf(listOf(jsonOf("tool" to jsonOf("driver" to driver(findings)), "columnKind" to "utf16CodeUnits",
        "results" to findings.map(::result)))),
)

private fun driver(findings: List<Finding>) =
    jsonOf("name" to "argo check", "rules" to findings.map { it.rule }.distinct().sorted().map { jsonOf("id" to it) })

private fun result(finding: Finding): JsonObject {
    val level = when (finding.level) {
        Level.ERROR -> "error"
        Level.WARNING -> "warning"
        Level.HINT -> "note"
    }
    val (begin, end) = finding.place.begin to finding.place.end
    val region = jsonOf("startLine" to begin.line, "startColumn" to begin.column, "endLine" to end.line, "endColumn" to end.column)
    val place = jsonOf("artifactLocation" to jsonOf("uri" to uriOf(fileOf(finding))), "region" to region)
    return jsonOf(
        "ruleId" to finding.rule, "level" to level, "message" to jsonOf("text" to "${finding.what}: ${finding.why}; ${finding.remedy}"),
        "locations" to listOf(jsonOf("physicalLocation" to place)),
    )
}

private fun uriOf(file: Path): String =
    if (file.isAbsolute) "${file.toUri()}" else URI(null, null, file.joinToString("/"), null).rawPath
