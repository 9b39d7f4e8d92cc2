package argo.tools.filter

import argo.filters.PerceptionFilter
import argo.filters.format.JsonFilters
import argo.filters.format.KotlinFilters
import argo.filters.format.XmlFilters
import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.ToolException
import argo.tools.command.making
import argo.tools.command.requireNew
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import kotlin.io.path.writeText

@Command(name = "convert", description = ["Writes the filter of a file in another form. The result equals the original, without comments."])
internal class FilterConvertCommand : ToolCommand() {
    @Parameters(index = "0", paramLabel = "FILE", description = ["XML or JSON"])
    private lateinit var file: Path

    @Option(names = ["--to"], required = true, paramLabel = "FORM", description = ["xml, json or kotlin"])
    private lateinit var form: String

    @Option(names = ["-o", "--out"], paramLabel = "FILE", description = ["writes to a new file instead of the terminal"])
    private var target: Path? = null

    override fun call(): Int {
        target?.let(::requireNew)
        val write = FORMS[form] ?: misuse("--to is ${FORMS.keys.joinToString()}, not $form")
        val filter = filterIn(file)
        val text = try {
            write(filter)
        } catch (unwritable: IllegalArgumentException) {
            throw ToolException("$file cannot be written as $form: ${unwritable.message}")
        }
        target?.let { making(it) { file -> file.writeText(text, Charsets.UTF_8, StandardOpenOption.CREATE_NEW) } } ?: out.print(text)
        out.flush()
        return ExitStatus.DONE
    }

    private companion object {
        val FORMS: Map<String, (PerceptionFilter) -> String> =
            mapOf("xml" to XmlFilters::write, "json" to JsonFilters::write, "kotlin" to KotlinFilters::write)
    }
}
