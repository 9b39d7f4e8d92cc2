package argo.filters.format

import argo.filters.FilterNotFoundException
import argo.filters.FilterProvider
import argo.filters.PerceptionFilter
import java.net.JarURLConnection
import java.net.URL
import java.nio.file.Path
import java.util.ServiceConfigurationError
import java.util.ServiceLoader
import kotlin.io.path.isRegularFile
import kotlin.io.path.toPath

/** A place with filters: a directory, or a part of the class path. `toString` returns the place's name for messages. */
internal interface FilterPlace {
    /** Returns the filter called [name], or null. The caller has checked that [name] does not lead out of the place. */
    fun find(name: String): PerceptionFilter?

    /** Returns the file on the disk that [find] reads for [name], or null. */
    fun path(name: String): Path? = null

    /** Returns the names of the place's filters, for messages. Empty if the place cannot be listed. */
    fun names(): List<String>
}

internal class ProvidedFilters(private val classLoader: ClassLoader) : FilterPlace {
    /** Each call loads the providers again, because a loader is not thread-safe. */
    private fun providers(): List<FilterProvider> = usable { ServiceLoader.load(FilterProvider::class.java, classLoader).toList() }

    override fun find(name: String): PerceptionFilter? {
        val found = providers().flatMap { provider -> filtersOf(provider).filter { it.name == name }.map { provider to it } }
        if (found.map { it.second }.distinct().size > 1) {
            val owners = found.map { it.first.javaClass.name }.distinct()
            throw FilterNotFoundException(
                "${owners.joinToString(" and ")} ${if (owners.size > 1) "offer" else "offers"} different filters of the name '$name'; give one of them another name.",
            )
        }
        return found.firstOrNull()?.second
    }

    override fun names(): List<String> = providers().flatMap(::filtersOf).map(PerceptionFilter::name)

    private fun filtersOf(provider: FilterProvider) = usable("${provider.javaClass.name} cannot make its filters") { provider.filters }

    /** Calls [load] and returns the result. If [load] fails, throws an error whose message lists all causes. */
    private fun <T> usable(words: String? = null, load: () -> T): T = try {
        load()
    } catch (broken: Throwable) {
        // a failing static initializer causes a linkage error
        if (broken !is ServiceConfigurationError && broken !is LinkageError && broken !is RuntimeException) throw broken
        val causes = generateSequence(broken) { it.cause }.toList()
        val known = listOfNotNull(words) + causes.mapNotNull { it.message }.distinct()
        throw ServiceConfigurationError(known.ifEmpty { listOf("$broken") }.joinToString(": "), broken)
    }

    override fun toString(): String = "the filters of ${FilterProvider::class.java.name} services"
}

internal class FilterResources(private val classLoader: ClassLoader, private val folder: String) : FilterPlace {

    override fun find(name: String): PerceptionFilter? = FilterFormat.candidates(name).firstNotNullOfOrNull { (fileName, format) ->
        val url = classLoader.getResource("$folder/$fileName")
        url?.takeIf(::isReadable)?.let { open(it).use { input -> format.read(input, "$url", FilterFormat.bareName(name)) } }
    }

    override fun names(): List<String> = classLoader.getResources(folder).asSequence().flatMap(::names).map(FilterFormat::bareName).toList()

    /** Accepts only regular files: reading a pipe may never end. */
    private fun isReadable(url: URL) = url.protocol != "file" || url.toURI().toPath().isRegularFile()

    private fun names(url: URL): List<String> = when (url.protocol) {
        "file" -> filesUnder(url.toURI().toPath())
        "jar" -> filesInJar(url)
        else -> emptyList()
    }

    private fun filesInJar(url: URL): List<String> {
        val connection = url.openConnection() as JarURLConnection
        connection.useCaches = false
        return connection.jarFile.use { jar ->
            jar.entries().asSequence().map { it.name }
                .filter { it.startsWith("$folder/") && FilterFormat.of(it) != null }
                .map { it.removePrefix("$folder/") }
                .toList()
        }
    }

    /** Opens [url] without the URL cache. The cache would keep the jar open. */
    private fun open(url: URL) = url.openConnection().apply { useCaches = false }.getInputStream()

    override fun toString(): String = "$folder/ on the class path"
}
