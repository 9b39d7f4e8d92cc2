package argo.perception

import argo.filters.NO_FILTER
import argo.filters.PerceptionFilter
import argo.filters.format.FilterFinder
import argo.platform.pathOf
import jason.asSemantics.Agent
import java.nio.file.Path
import kotlin.io.path.isDirectory

/**
 * Finds the filter that [agent] calls [name]. Returns null for the name `none`. Searches the filters of services, the start directory of
 * the project, the directory of the agent's `.asl`, `filters/` in both directories, and `filters/` on the class path.
 *
 * @throws argo.filters.FilterNotFoundException if no filter has this name
 * @throws argo.filters.FilterException if the filter is refused
 */
internal fun filterOf(agent: Agent, name: String): PerceptionFilter? = if (name == NO_FILTER) null else finderOf(agent).find(name)

/** Returns the file on a disk in which [filterOf] finds the filter; null if the filter is not in a file. */
internal fun filterPath(agent: Agent, name: String): Path? = finderOf(agent).path(name)

internal fun filterNames(agent: Agent): List<String> = finderOf(agent).names()

private fun finderOf(agent: Agent) = FilterFinder(projectDirectories(agent), agent.javaClass.classLoader)

private fun projectDirectories(agent: Agent): List<Path> {
    val started = Path.of("").toAbsolutePath()
    return listOfNotNull(started, agent.aslSrc?.let(::pathOf)?.parent?.takeIf { it.isDirectory() && it != started })
}
