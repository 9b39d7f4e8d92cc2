package argo.tools.filter

import argo.filters.FilterException
import argo.filters.Problem
import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.printable
import argo.tools.command.saidTo
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.nio.file.Path

/** `filter check`: whether files can be read. */
@Command(name = "check", description = ["Says of each file what its filter does, or everything that is wrong with it; then the exit status is 1."])
internal class FilterCheckCommand : ToolCommand() {
    @Parameters(arity = "1..*", paramLabel = "FILE", description = ["XML or JSON"])
    private lateinit var files: List<Path>

    @Option(names = ["--json"], description = ["prints an array of objects of JSON"])
    private var json = false

    override fun call(): Int {
        val checks = files.map(::check)
        if (json) out.println(JsonArray(checks.map(::json))) else checks.forEach(::print)
        return if (checks.all { it.says != null }) ExitStatus.DONE else ExitStatus.FAILED
    }

    private class Check(val file: Path, val says: String?, val problems: List<Problem>)

    private fun check(file: Path): Check = try {
        Check(file, filterIn(file).toString(), emptyList())
    } catch (refused: FilterException) {
        Check(file, null, refused.problems)
    } catch (failure: Exception) {
        Check(file, null, listOf(Problem("$file", 1, 1, saidTo(failure) ?: throw failure)))
    }

    private fun print(check: Check) {
        if (check.says != null) out.println("${check.file}: ${paint.good("ok")}: ${printable(check.says)}")
        check.problems.forEach { err.println(paint.bad(printable("$it"))) }
    }

    private fun json(check: Check): JsonObject = buildJsonObject {
        put("file", "${check.file}")
        put("ok", check.says != null)
        put("says", check.says)
        put(
            "problems",
            JsonArray(check.problems.map { buildJsonObject { put("line", it.line); put("column", it.column); put("message", it.message) } }),
        )
    }
}
