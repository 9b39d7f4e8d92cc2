package argo.tools.migration

import argo.tools.command.ToolException
import argo.tools.command.sourcesIn
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.isDirectory
import kotlin.io.path.name
import kotlin.io.path.readBytes

/** Checks programs for other versions of ARGO. */
internal class Migration(files: List<Path>) {
    private val files = files.flatMap(::expanded).distinct()
    private val kotlinFilters = kotlinFiltersIn(files.filter { it.isDirectory() } + Path.of("src"))

    /** Returns the advices on all files, file by file in the order of the lines. */
    fun advices(): List<Advice> {
        val agents = files.filter { it.extension == "asl" }.map { it to AgentCheck(it, textOf(it)) }
        val needArch = agents.filter { it.second.needsArch }.map { it.first.name }.toSet()
        val ofAgents = agents.flatMap { (file, check) -> check.advices() + missingFilters(file, check) }
        val ofProjects = files.filter { it.extension in PROJECTS }.flatMap { ProjectCheck(it, textOf(it)).advices(needArch) }
        val isForOtherVersion = agents.isEmpty() || agents.any { it.second.isForOtherVersion }
        val changedTo = agents.flatMap { (file, check) -> check.filters.mapNotNull { filterFile(file, it.first) } }
        val ofFilters = (files + changedTo).filter { it.extension == "xml" }.distinctBy { it.toAbsolutePath().normalize() }
            .flatMap { FilterFileCheck(it, isForOtherVersion).advices() }
        return ofAgents + ofProjects + ofFilters
    }

    val count: Int get() = files.size

    private fun missingFilters(file: Path, check: AgentCheck): List<Advice> =
        check.filters.filter { it.first !in kotlinFilters && filterFile(file, it.first) == null }.map { (name, line) ->
            val what = "there is no file of the filter $name beside the agent or in the working directory, nor in filters/ there, " +
                "and no Kotlin source that makes it"
            Advice("$file", line, false, what, "no change is needed if it is on the class path; else put it there")
        }

    private fun filterFile(asl: Path, name: String): Path? {
        val folders = listOf(asl.toAbsolutePath().parent, Path.of("").toAbsolutePath()).flatMap { listOf(it, it.resolve("filters")) }
        val names = if (name.endsWith(".xml") || name.endsWith(".json")) listOf(name) else listOf("$name.xml", "$name.json")
        return folders.firstNotNullOfOrNull { folder -> names.map(folder::resolve).find(Files::isRegularFile) }
    }

    private fun expanded(file: Path): List<Path> = when {
        file.isDirectory() -> sourcesIn(file, KNOWN).ifEmpty { throw ToolException("$file has no file that can be checked, as $THESE") }
        !Files.exists(file) -> throw ToolException("there is no file $file")
        file.extension !in KNOWN -> throw ToolException("$file cannot be checked; files that can: $THESE")
        else -> listOf(file)
    }

    /** Reads [file] in UTF-8, or in ISO 8859-1 if it is an old program; the checks need ASCII only. */
    private fun textOf(file: Path): String = try {
        file.readBytes().toString(Charsets.UTF_8)
    } catch (unreadable: IOException) {
        throw ToolException("$file cannot be read: $unreadable")
    }

    private companion object {
        val PROJECTS = setOf("mas2j", "jcm", "gradle", "kts")
        val KNOWN = PROJECTS + setOf("asl", "xml")
        val THESE = KNOWN.joinToString { ".$it" }
    }
}

/** Returns the names of the filters that Kotlin sources below [folders] make. */
private fun kotlinFiltersIn(folders: List<Path>): Set<String> = folders.filter { it.isDirectory() }
    .flatMap { sourcesIn(it, setOf("kt")) }.distinct()
    .flatMap { source -> FILTER_MADE.findAll(source.readBytes().toString(Charsets.UTF_8)).map { it.groupValues[1] } }.toSet()

private val FILTER_MADE = Regex("""\b(?:dropFilter|keepFilter)\(\s*(?:name\s*=\s*)?"([^"]+)"""")
