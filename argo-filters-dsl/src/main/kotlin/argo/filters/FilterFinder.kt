package argo.filters

import java.nio.file.Path

/** Finds filters by name. */
class FilterFinder(private val projectDirectory: Path, private val classLoader: ClassLoader) {
    /**
     * The filter called [name].
     *
     * @throws FilterNotFoundException if there is none; the message says where it was looked for and which filters there are
     * @throws FilterException if its text is refused
     * @throws java.io.IOException if its file cannot be read
     */
    fun find(name: String): PerceptionFilter = TODO("$name $projectDirectory $classLoader")
}
