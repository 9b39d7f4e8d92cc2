package argo.filters.format

import argo.filters.FilterNotFoundException
import argo.filters.PerceptionFilter
import java.io.IOException
import java.nio.file.FileVisitResult
import java.nio.file.Path
import kotlin.io.path.inputStream
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.isRegularFile
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.visitFileTree

/**
 * A directory with filter files. A link is followed only if it leads to a file within [boundary]. If [foreignFiles] is true, the
 * directory may also contain other files. [names] leaves these out.
 */
internal class FilterDirectory(private val directory: Path, private val boundary: Path, private val foreignFiles: Boolean) : FilterPlace {

    override fun find(name: String): PerceptionFilter? {
        val (fileName, format) = candidate(name) ?: return null
        val file = directory.resolve(fileName)
        val real = file.toRealPath()
        if (!real.startsWith(boundary.toRealPath())) {
            val problem = "is the file $file, which is a link that leads out of $boundary to $real"
            throw FilterNotFoundException("The filter '$name' $problem; copy it there instead.")
        }
        return real.inputStream().use { format.read(it, file.toString(), FilterFormat.bareName(name)) }
    }

    private fun candidate(name: String) = FilterFormat.candidates(name).find { (it, _) -> directory.resolve(it).isRegularFile() }

    override fun path(name: String): Path? = candidate(name)?.let { (fileName, _) -> directory.resolve(fileName) }

    override fun names(): List<String> =
        filesUnder(directory, if (foreignFiles) 1 else DEPTH).filter { !foreignFiles || isFilter(it) }.map(FilterFormat::bareName)

    /** Returns true if a file looks like a filter. An unreadable file counts as a filter. */
    private fun isFilter(fileName: String): Boolean = try {
        FilterFormat.of(fileName)?.isLikely(directory.resolve(fileName).readText(Charsets.ISO_8859_1)) == true
    } catch (_: IOException) {
        true
    }

    override fun toString(): String = directory.toString()
}

private const val DEPTH = 8

/** Returns the filter files under [directory], as relative paths. Empty if [directory] is no directory. */
internal fun filesUnder(directory: Path, depth: Int = DEPTH): List<String> = buildList {
    directory.visitFileTree(depth) {
        onVisitFile { file, _ ->
            val isFilter = FilterFormat.of(file.name) != null && file.isRegularFile()
            if (isFilter) add(directory.relativize(file).invariantSeparatorsPathString)
            FileVisitResult.CONTINUE
        }
        onVisitFileFailed { _, _ -> FileVisitResult.CONTINUE }
    }
}
