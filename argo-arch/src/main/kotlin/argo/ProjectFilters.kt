package argo

import argo.filters.FilterFinder
import argo.filters.FilterNotFoundException
import argo.filters.PerceptionFilter
import jason.asSemantics.Agent
import java.net.URI
import java.nio.file.Files
import java.nio.file.Path

/**
 * Finds the filter that [agent] calls [name]: in the directory that the project was started in, then in that of the agent's
 * `.asl`, in `filters/` under each, and in `filters/` on the class path.
 *
 * @throws FilterNotFoundException if there is none
 * @throws argo.filters.FilterException if it is refused
 */
internal fun filterOf(agent: Agent, name: String): PerceptionFilter {
    val finders = projectDirectories(agent).map { FilterFinder(it, agent.javaClass.classLoader) }
    var notFound: FilterNotFoundException? = null
    for (finder in finders) {
        try {
            return finder.find(name)
        } catch (missing: FilterNotFoundException) {
            notFound = notFound ?: missing
        }
    }
    throw checkNotNull(notFound)
}

private fun projectDirectories(agent: Agent): List<Path> {
    val started = Path.of("").toAbsolutePath()
    return listOfNotNull(started, directoryOf(agent.aslSrc)?.takeIf { it != started })
}

private fun directoryOf(source: String?): Path? = try {
    source?.let { if (it.startsWith("file:/")) Path.of(URI(it)) else Path.of(it.removePrefix("file:")) }
        ?.toAbsolutePath()?.normalize()?.parent?.takeIf(Files::isDirectory)
} catch (_: IllegalArgumentException) {
    null // not a file: an .asl from a jar or the class path
} catch (_: java.net.URISyntaxException) {
    null
}
