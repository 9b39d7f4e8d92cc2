package argo.tools.migration

import argo.tools.command.sourcesIn
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.readBytes

/** Returns the names of the filters that Kotlin sources below [folders] make. */
internal fun kotlinFiltersIn(folders: List<Path>): Set<String> = folders.filter { it.isDirectory() }
    .flatMap { sourcesIn(it, setOf("kt")) }.distinct()
    .flatMap { source -> FILTER_MADE.findAll(source.readBytes().toString(Charsets.UTF_8)).map { it.groupValues[1] } }.toSet()

private val FILTER_MADE = Regex("""\b(?:dropFilter|keepFilter)\(\s*(?:name\s*=\s*)?"([^"]+)"""")
