package argo.filters

import java.io.IOException
import java.net.JarURLConnection
import java.net.URL
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes
import kotlin.io.path.extension
import kotlin.io.path.inputStream
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.isRegularFile
import kotlin.io.path.readText
import kotlin.io.path.toPath

/** Somewhere filters may be. `toString` tells a person where. */
internal interface FilterPlace {
    /** The filter called [name], which has no extension and does not lead out of the place, or null. */
    fun find(name: String): PerceptionFilter?

    /** The names of the filters that are there, for messages; a place that cannot be listed has none. */
    fun names(): List<String>
}

/**
 * A directory with filter files. Files that are links are followed as long as they stay inside [boundary].
 *
 * @param foreignFiles whether the directory is likely to hold XML files that are no filters, which [names] then leaves out
 */
internal class FilterDirectory(private val directory: Path, private val boundary: Path, private val foreignFiles: Boolean) : FilterPlace {

    override fun find(name: String): PerceptionFilter? {
        val file = directory.resolve(name + FilterFinder.EXTENSION)
        if (!file.isRegularFile()) return null
        val real = file.toRealPath()
        if (!real.startsWith(boundary.toRealPath())) {
            throw FilterNotFoundException("The filter '$name' is the file $file, which is a link that leads out of $boundary to $real; copy it there instead.")
        }
        return real.inputStream().use { XmlFilters.read(it, file.toString(), name) }
    }

    override fun names(): List<String> = namesUnder(directory, if (foreignFiles) 1 else DEPTH).filter { !foreignFiles || isFilter(it) }

    /** Whether a file looks like a filter. One that cannot be read is left in the list, since it is not known to be anything else. */
    private fun isFilter(name: String): Boolean = try {
        "<PerceptionFilter" in directory.resolve(name + FilterFinder.EXTENSION).readText(Charsets.ISO_8859_1)
    } catch (_: IOException) {
        true
    }

    override fun toString(): String = directory.toString()
}

/** A folder on the class path. */
internal class FilterResources(private val classLoader: ClassLoader, private val folder: String) : FilterPlace {

    override fun find(name: String): PerceptionFilter? {
        val path = "$folder/$name${FilterFinder.EXTENSION}"
        val url = classLoader.getResource(path) ?: return null
        return open(url).use { XmlFilters.read(it, url.toString(), name) }
    }

    override fun names(): List<String> = classLoader.getResources(folder).asSequence().flatMap(::names).toList()

    private fun names(url: URL): List<String> = when (url.protocol) {
        "file" -> namesUnder(url.toURI().toPath(), DEPTH)
        "jar" -> namesInJar(url)
        else -> emptyList()
    }

    private fun namesInJar(url: URL): List<String> {
        val connection = url.openConnection() as JarURLConnection
        connection.useCaches = false
        return connection.jarFile.use { jar ->
            jar.entries().asSequence().map { it.name }
                .filter { it.startsWith("$folder/") && it.endsWith(FilterFinder.EXTENSION) }
                .map { it.removePrefix("$folder/").removeSuffix(FilterFinder.EXTENSION) }
                .toList()
        }
    }

    /** Without the cache that URLs of jars have, so that no jar stays open. */
    private fun open(url: URL) = url.openConnection().apply { useCaches = false }.getInputStream()

    override fun toString(): String = "$folder/ on the class path"
}

/** How deep folders of filters are listed. */
private const val DEPTH = 8

private fun namesUnder(directory: Path, depth: Int): List<String> {
    val names = ArrayList<String>()
    val collector = object : SimpleFileVisitor<Path>() {
        override fun visitFile(file: Path, attributes: BasicFileAttributes): FileVisitResult {
            if (file.extension == "xml" && file.isRegularFile()) names += nameOf(directory.relativize(file))
            return FileVisitResult.CONTINUE
        }

        override fun visitFileFailed(file: Path, cause: IOException) = FileVisitResult.CONTINUE
    }
    Files.walkFileTree(directory, emptySet(), depth, collector)
    return names
}

private fun nameOf(file: Path) = file.invariantSeparatorsPathString.removeSuffix(FilterFinder.EXTENSION)
