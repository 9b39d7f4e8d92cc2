package argo.tools.command

import java.nio.file.AccessDeniedException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.LinkOption
import java.nio.file.Path

/**
 * Refuses to make [file] if something of its name is there already, or no folder for it; so this is known before anything else is done.
 *
 * @throws ToolException if it cannot be made
 */
internal fun requireNew(file: Path) {
    if (Files.exists(file, LinkOption.NOFOLLOW_LINKS)) throw ToolException("$file is there already, and is not overwritten")
    requireFolder(folderOf(file))
}

/**
 * What [make] makes under the new name [file].
 *
 * @throws ToolException if that is impossible; the message names the folder where that is at fault
 */
internal fun <T> making(file: Path, make: (Path) -> T): T {
    requireNew(file)
    return try {
        make(file)
    } catch (_: FileAlreadyExistsException) {
        throw ToolException("$file is there already, and is not overwritten")
    } catch (_: AccessDeniedException) {
        throw ToolException("this user may not make anything in the folder ${folderOf(file)}")
    } catch (refused: FileSystemException) { // as in /proc, or on a disk that is full or read-only
        throw ToolException("nothing can be made in the folder ${folderOf(file)}${refused.reason?.let { ": $it" }.orEmpty()}")
    }
}

private fun folderOf(file: Path): Path = file.toAbsolutePath().normalize().parent ?: file

private fun requireFolder(folder: Path) {
    if (!Files.exists(folder)) throw ToolException("there is no folder $folder")
    if (!Files.isDirectory(folder)) throw ToolException("$folder is no folder")
}

/**
 * Refuses to read [file] if there is none, or it is a folder.
 *
 * @throws ToolException with the reason
 */
internal fun requireFile(file: Path) {
    if (!Files.exists(file)) throw ToolException("there is no file $file")
    if (Files.isDirectory(file)) throw ToolException("$file is a folder, no file")
}
