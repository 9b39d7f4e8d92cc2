package argo.ros.mapping

import argo.filters.Problem
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path

private val NAME = Regex("[A-Za-z0-9_][A-Za-z0-9_.-]*(/[A-Za-z0-9_][A-Za-z0-9_.-]*)*")

/** Matches text that an HTTP header can contain. */
private val TOKEN = Regex("[!-~]+")

internal const val SUFFIX = ".ros.yaml"

/**
 * Reads the mapping [name] from [directory]. If it is not there, reads it from the class path. The name may contain folders.
 *
 * @throws MappingException if the mapping is refused, or not found
 */
internal fun findMapping(name: String, directory: Path = Path.of("").toAbsolutePath()): Mapping {
    val fileName = "$name$SUFFIX"
    if (!NAME.matches(name)) {
        throw notRead(fileName, "'$name' is no name of a mapping: letters, digits, '_', '-', '.', and '/' behind folders")
    }
    val file = directory.resolve(fileName)
    if (Files.isRegularFile(file)) return mappingIn(file)
    val loaders = listOfNotNull(Thread.currentThread().contextClassLoader, Mapping::class.java.classLoader)
    val resource = loaders.firstNotNullOfOrNull { it.getResource(fileName) }
        ?: throw notRead(fileName, "there is no such file in $directory, nor on the class path; it says which topics are which percepts")
    val bytes = resource.openConnection().apply { useCaches = false }.getInputStream().use { it.readBytes() }
    return mappingOf(text(fileName) { bytes.decodeToString(throwOnInvalidSequence = true) }, fileName)
}

/**
 * Reads the mapping in [file].
 *
 * @throws MappingException if it is refused, or cannot be read
 */
internal fun mappingIn(file: Path): Mapping = mappingOf(text("$file") { Files.readString(file) }, "$file")

private fun text(source: String, read: () -> String): String = try {
    read()
} catch (_: CharacterCodingException) {
    throw notRead(source, "it is not in UTF-8")
} catch (_: NoSuchFileException) {
    throw notRead(source, "there is no such file")
} catch (unreadable: IOException) {
    throw notRead(source, "it cannot be read: ${unreadable.message}")
}

/**
 * The credentials of a client for a bridge, or for a server in front of it.
 *
 * @property token sent as `Authorization: Bearer …`, or null if there is none
 * @property secret the secret for the parameter `authenticate` of `rosbridge_server` in ROS 1, or null if there is none
 */
internal class Credentials(val token: String? = null, val secret: String? = null)

/**
 * Reads the credentials for the bridge of the mapping [name] from the files `NAME.ros.token` and `NAME.ros.secret` in [directory].
 *
 * @throws MappingException if one of these files cannot be read, or holds no token or secret
 */
internal fun findCredentials(name: String, directory: Path = Path.of("").toAbsolutePath()) =
    Credentials(findToken(name, "token", directory), findToken(name, "secret", directory))

private fun findToken(name: String, kind: String, directory: Path): String? {
    val file = directory.resolve("$name.ros.$kind")
    if (!NAME.matches(name) || !Files.isRegularFile(file)) return null
    val token = text("$file") { Files.readString(file) }.trim()
    if (!TOKEN.matches(token)) throw notRead("$file", "it holds no $kind, which is one line of letters, digits and signs without blanks")
    return token
}

private fun notRead(source: String, message: String) = MappingException(listOf(Problem(source, 1, 1, message)))
