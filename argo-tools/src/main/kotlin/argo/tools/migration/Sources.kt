package argo.tools.migration

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.isDirectory
import kotlin.io.path.name
import kotlin.io.path.readBytes

/** The files below [folder] with one of these [extensions], sorted; without hidden files and outputs of builds. */
internal fun sourcesIn(folder: Path, extensions: Set<String>): List<Path> = Files.walk(folder).use { found ->
    found.filter { it.extension in extensions && Files.isRegularFile(it) && !isBuilt(folder.relativize(it)) }.sorted().toList()
}

private fun isBuilt(path: Path) = path.any { it.name in setOf("build", "target", "bin") || it.name.startsWith(".") }

/** The names of the filters that Kotlin sources below [folders] make. */
internal fun kotlinFiltersIn(folders: List<Path>): Set<String> = folders.filter { it.isDirectory() }
    .flatMap { sourcesIn(it, setOf("kt")) }.distinct()
    .flatMap { source -> FILTER_MADE.findAll(source.readBytes().toString(Charsets.UTF_8)).map { it.groupValues[1] } }.toSet()

private val FILTER_MADE = Regex("""\b(?:dropFilter|keepFilter)\(\s*(?:name\s*=\s*)?"([^"]+)"""")
