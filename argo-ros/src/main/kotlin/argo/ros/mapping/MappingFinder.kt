package argo.ros.mapping

import argo.filters.Problem
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

private val NAME = Regex("[A-Za-z0-9_][A-Za-z0-9_.-]*(/[A-Za-z0-9_][A-Za-z0-9_.-]*)*")

/** What mappings end with. */
internal const val SUFFIX = ".ros.yaml"

/**
 * Reads the mapping [name], which may hold folders, anew from [directory] or, if there is none, from the class path.
 *
 * @throws MappingException if it is refused, or not found
 */
internal fun findMapping(name: String, directory: Path = Path.of("").toAbsolutePath()): Mapping {
    val fileName = "$name$SUFFIX"
    if (!NAME.matches(name)) {
        throw notRead(fileName, "'$name' is no name of a mapping: letters, digits, '_', '-', '.', and '/' behind folders")
    }
    val file = directory.resolve(fileName)
    if (Files.isRegularFile(file)) {
        val text = try {
            Files.readString(file)
        } catch (_: CharacterCodingException) {
            throw notRead("$file", "it is not in UTF-8")
        } catch (unreadable: IOException) {
            throw notRead("$file", "it cannot be read: $unreadable")
        }
        return mappingOf(text, "$file")
    }
    val loaders = listOfNotNull(Thread.currentThread().contextClassLoader, Mapping::class.java.classLoader)
    val resource = loaders.firstNotNullOfOrNull { it.getResource(fileName) }
        ?: throw notRead(fileName, "there is no such file in $directory, nor on the class path; it says which topics are which percepts")
    val text = resource.openConnection().apply { useCaches = false }.getInputStream().use { it.readBytes().decodeToString() }
    return mappingOf(text, fileName)
}

private fun notRead(source: String, message: String) = MappingException(listOf(Problem(source, 1, 1, message)))
