package argo.tools.command

import java.nio.file.AccessDeniedException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.LinkOption
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.name

/**
 * Checks that [file] does not exist, and that its folder exists. Call this function before any other work.
 *
 * @throws ToolException if [file] cannot be made
 */
internal fun requireNew(file: Path) {
    val folder = folderOf(file)
    when {
        Files.exists(file, LinkOption.NOFOLLOW_LINKS) -> throw ToolException("$file exists already, and is not overwritten")
        !Files.exists(folder) -> throw ToolException("there is no folder $folder")
        !Files.isDirectory(folder) -> throw ToolException("$folder is no folder")
    }
}

/**
 * Returns the result of [make] for the new file [file].
 *
 * @throws ToolException if [file] cannot be made. If the folder is the cause, the message names it
 */
internal fun <T> making(file: Path, make: (Path) -> T): T {
    requireNew(file)
    return try {
        make(file)
    } catch (_: FileAlreadyExistsException) {
        throw ToolException("$file exists already, and is not overwritten")
    } catch (_: AccessDeniedException) {
        throw ToolException("this user may make no files in the folder ${folderOf(file)}")
    } catch (refused: FileSystemException) { // the folder is in /proc, or on a full or read-only disk
        throw ToolException("no files can be made in the folder ${folderOf(file)}${refused.reason?.let { ": $it" }.orEmpty()}")
    }
}

private fun folderOf(file: Path): Path = file.toAbsolutePath().normalize().parent ?: file

/**
 * Checks that [file] is a regular file. Reading a pipe without a writer would never end.
 *
 * @throws ToolException if [file] is no regular file
 */
fun requireFile(file: Path) {
    if (!Files.exists(file)) throw ToolException("there is no file $file")
    if (Files.isDirectory(file)) throw ToolException("$file is a folder, no file")
    if (!Files.isRegularFile(file)) throw ToolException("$file is no regular file; copy its content into one")
}

/**
 * Opens all [files] by [open] and calls [work] with them, behind those in [opened]. Returns the result of [work]. Closes all that it has
 * opened.
 */
fun <T : AutoCloseable, R> withAll(files: List<Path>, open: (Path) -> T, opened: List<T> = emptyList(), work: (List<T>) -> R): R =
    if (files.isEmpty()) work(opened) else open(files.first()).use { withAll(files.drop(1), open, opened + it, work) }

/** Returns the sorted files below [folder] that have one of these [extensions]. Leaves out hidden files and build outputs. */
internal fun sourcesIn(folder: Path, extensions: Set<String>): List<Path> = Files.walk(folder).use { found ->
    found.filter { it.extension in extensions && Files.isRegularFile(it) && !isBuilt(folder.relativize(it)) }.sorted().toList()
}

private fun isBuilt(path: Path) = path.any { it.name in setOf("build", "target", "bin") || it.name.startsWith(".") }
