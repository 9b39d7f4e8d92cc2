package argo.ros.mapping

import argo.filters.Problem
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

private val NAME = Regex("[A-Za-z0-9_][A-Za-z0-9_.-]*(/[A-Za-z0-9_][A-Za-z0-9_.-]*)*")

/** The characters that are valid in an HTTP header. */
private val TOKEN = Regex("[!-~]+")

internal const val SUFFIX = ".ros.yaml"

/**
 * Reads the mapping [name] anew from [directory], or from the class path if [directory] does not have it. The name may begin with folders.
 *
 * @throws MappingException if the mapping is refused, or not found
 */
internal fun findMapping(name: String, directory: Path = Path.of("").toAbsolutePath()): Mapping {
    val fileName = "$name$SUFFIX"
    if (!NAME.matches(name)) {
        throw notRead(fileName, "'$name' is no name of a mapping: letters, digits, '_', '-', '.', and '/' behind folders")
    }
    val file = directory.resolve(fileName)
    if (Files.isRegularFile(file)) {
        return mappingOf(text("$file") { Files.readString(file) }, "$file")
    }
    val loaders = listOfNotNull(Thread.currentThread().contextClassLoader, Mapping::class.java.classLoader)
    val resource = loaders.firstNotNullOfOrNull { it.getResource(fileName) }
        ?: throw notRead(fileName, "there is no such file in $directory, nor on the class path; it says which topics are which percepts")
    val bytes = resource.openConnection().apply { useCaches = false }.getInputStream().use { it.readBytes() }
    return mappingOf(text(fileName) { bytes.decodeToString(throwOnInvalidSequence = true) }, fileName)
}

private fun text(source: String, read: () -> String): String = try {
    read()
} catch (_: CharacterCodingException) {
    throw notRead(source, "it is not in UTF-8")
} catch (unreadable: IOException) {
    throw notRead(source, "it cannot be read: $unreadable")
}

/**
 * Reads the token for the bridge of the mapping [name] from the file `NAME.ros.token` in [directory]; null: there is no such file.
 *
 * @throws MappingException if the file cannot be read, or contains no token
 */
internal fun findToken(name: String, directory: Path = Path.of("").toAbsolutePath()): String? {
    val file = directory.resolve("$name.ros.token")
    if (!NAME.matches(name) || !Files.isRegularFile(file)) return null
    val token = try {
        Files.readString(file).trim()
    } catch (unreadable: IOException) {
        throw notRead("$file", "it cannot be read: $unreadable")
    }
    if (!TOKEN.matches(token)) throw notRead("$file", "it holds no token, which is one line of letters, digits and signs without blanks")
    return token
}

private fun notRead(source: String, message: String) = MappingException(listOf(Problem(source, 1, 1, message)))
