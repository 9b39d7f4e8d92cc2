package argo.tools.filter

import argo.filters.PerceptionFilter
import argo.filters.format.JsonFilters
import argo.filters.format.XmlFilters
import argo.tools.command.ToolException
import argo.tools.command.requireFile
import java.nio.file.Path
import kotlin.io.path.inputStream

/**
 * Reads the filter in [file], whose name says whether it is XML or JSON.
 *
 * @throws argo.filters.FilterException if it is refused
 */
internal fun filterIn(file: Path): PerceptionFilter {
    val name = file.toString()
    return when {
        name.endsWith(".xml") -> existing(file).inputStream().use { XmlFilters.read(it, name) }
        name.endsWith(".json") -> existing(file).inputStream().use { JsonFilters.read(it, name) }
        else -> throw ToolException("$file is no filter file: their names end in .xml or .json")
    }
}

private fun existing(file: Path): Path = file.also(::requireFile)
