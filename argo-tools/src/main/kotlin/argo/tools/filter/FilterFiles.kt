package argo.tools.filter

import argo.filters.PerceptionFilter
import argo.filters.format.JsonFilters
import argo.filters.format.XmlFilters
import argo.tools.command.ToolException
import argo.tools.command.requireFile
import argo.tools.command.sourcesIn
import java.io.InputStream
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.inputStream
import kotlin.io.path.readText

/**
 * Reads the filter in [file]. The file name's extension decides between XML and JSON.
 *
 * @throws argo.filters.FilterException if the filter is refused
 */
internal fun filterIn(file: Path): PerceptionFilter {
    requireFile(file)
    val name = "$file"
    val read = when {
        name.endsWith(".xml") -> { input: InputStream -> XmlFilters.read(input, name) }
        name.endsWith(".json") -> { input: InputStream -> JsonFilters.read(input, name) }
        else -> throw ToolException("$file is no filter file: their names end in .xml or .json")
    }
    return file.inputStream().use(read)
}

/**
 * Returns the probable filter files below [folder], and all other XML and JSON files. A probable filter contains `<PerceptionFilter` or
 * `"rules"`.
 */
internal fun filtersIn(folder: Path): Pair<List<Path>, List<Path>> = sourcesIn(folder, MARKS.keys).partition { file ->
    MARKS.getValue(file.extension) in file.readText(Charsets.ISO_8859_1)
}

private val MARKS = mapOf("xml" to "<PerceptionFilter", "json" to "\"rules\"")
