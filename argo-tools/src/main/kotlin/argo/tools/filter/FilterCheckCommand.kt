package argo.tools.filter

import argo.filters.FilterException
import argo.filters.PerceptionFilter
import argo.filters.Problem
import argo.filters.matching.warnings
import argo.filters.withControlsShown
import argo.tools.command.DataCommand
import argo.tools.command.ExitStatus
import argo.tools.command.jsonArrayOf
import argo.tools.command.jsonOf
import argo.tools.command.messageOf
import picocli.CommandLine.Command
import picocli.CommandLine.Parameters
import java.nio.file.Path
import kotlin.io.path.isDirectory

@Command(
    name = "check",
    description = [
        "Describes the filter of each file and warns of parts without effect, or lists all its problems; then the exit status is 1.",
    ],
)
internal class FilterCheckCommand : DataCommand() {
    @Parameters(arity = "1..*", paramLabel = "FILE", description = ["XML or JSON, or folders with such files"])
    private lateinit var files: List<Path>

    override fun call(): Int {
        val checks = files.flatMap(::checked)
        if (json) out.println(jsonArrayOf(checks.map(::json))) else checks.forEach(::print)
        return if (checks.all { it.filter != null }) ExitStatus.DONE else ExitStatus.FAILED
    }

    private class Check(val file: Path, val filter: PerceptionFilter?, val problems: List<Problem>) {
        val warnings = filter?.warnings().orEmpty()
    }

    private fun checked(file: Path): List<Check> {
        if (!file.isDirectory()) return listOf(check(file))
        val none = Problem("$file", 1, 1, "there is no filter in this folder: no file with <PerceptionFilter> in it, or with \"rules\"")
        val (filters, others) = filtersIn(file)
        if (filters.isNotEmpty() && others.isNotEmpty()) {
            val names = others.take(SHOWN).joinToString { withControlsShown("$it") } + if (others.size > SHOWN) ", …" else ""
            err.println("$file: left out, for they look like no filters: $names")
        }
        return filters.map(::check).ifEmpty { listOf(Check(file, null, listOf(none))) }
    }

    private fun check(file: Path): Check = try {
        Check(file, filterIn(file), emptyList())
    } catch (refused: FilterException) {
        Check(file, null, refused.problems)
    } catch (failure: Exception) {
        Check(file, null, listOf(Problem("$file", 1, 1, messageOf(failure) ?: throw failure)))
    }

    private fun print(check: Check) {
        if (check.filter != null) out.println("${check.file}: ${paint.good("ok")}: ${withControlsShown("${check.filter}")}")
        check.warnings.forEach { out.println("${check.file}: ${paint.doubtful("warning")}: ${withControlsShown(it)}") }
        check.problems.forEach { err.println(paint.bad(withControlsShown("$it"))) }
    }

    private fun json(check: Check) = jsonOf(
        "file" to check.file, "ok" to (check.filter != null), "says" to check.filter, "warnings" to check.warnings,
        "problems" to check.problems.map { jsonOf("line" to it.line, "column" to it.column, "message" to it.message) },
    )

    private companion object {
        const val SHOWN = 20
    }
}
