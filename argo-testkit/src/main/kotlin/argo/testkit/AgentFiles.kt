package argo.testkit

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createTempDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.writeText

/**
 * Finds the file of the agent [source].
 *
 * @param first directories to search before the usual ones
 * @throws IllegalArgumentException if the file does not exist
 */
internal fun found(source: String, first: List<String> = emptyList()): Path = found("agent", source, first + DIRECTORIES)

/** Finds the file [name] in the first of [directories] that contains it. Messages call it a [kind]. */
internal fun found(kind: String, name: String, directories: List<String>): Path {
    val places = directories.map { Path.of(it, name).toAbsolutePath().normalize() }
    return places.firstOrNull { it.isRegularFile() }
        ?: throw IllegalArgumentException("there is no $kind $name; looked for ${places.joinToString()}")
}

/** @throws IllegalArgumentException if there is no such file */
internal fun existing(file: Path): Path {
    require(file.isRegularFile()) { "there is no agent ${file.toAbsolutePath().normalize()}" }
    return file.toAbsolutePath().normalize()
}

internal fun written(program: String, work: (Path) -> Unit) {
    val directory = createTempDirectory("argo-testkit")
    val file = directory.resolve("agent.asl").apply { writeText(program) }
    try {
        work(file)
    } finally {
        Files.delete(file)
        Files.delete(directory)
    }
}

private val DIRECTORIES = listOf("", "src/agt", "src/main/asl", "src/test/resources")
