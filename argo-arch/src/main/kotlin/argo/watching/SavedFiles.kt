package argo.watching

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.BasicFileAttributes
import java.nio.file.attribute.FileTime

/**
 * Notices saved files by repeated looks. A file counts as saved if it has changed and two later looks in a row find it unchanged. Many
 * editors write a file in several steps. Not safe for use by several threads.
 *
 * @param stampOf returns the state of a file; null if it cannot be read
 */
internal class SavedFiles(private val stampOf: (Path) -> FileStamp? = FileStamp::of) {
    private var taken: Map<Path, FileStamp?> = emptyMap()
    private var seen: Map<Path, FileStamp?> = emptyMap()

    /**
     * Looks at [files], and returns those that were saved since they were last returned. If the last look did not include a file, the file
     * counts as unchanged.
     */
    fun look(files: Collection<Path>): List<Path> {
        val now = files.associateWith(stampOf)
        val saved = files.filter { now[it] == seen[it] && it in taken && now[it] != taken[it] }
        taken = now.mapValues { (file, stamp) -> if (file in saved || file !in taken) stamp else taken[file] }
        seen = now
        return saved
    }

    companion object {
        const val LOOK_EACH_MS = 250L
    }
}

/**
 * The state of a file, which differs after each change.
 *
 * @property key identifies the file itself, since an editor may replace it by a new file; null if there is no key
 */
internal data class FileStamp(val time: FileTime, val bytes: Long, val key: Any?) {
    companion object {
        fun of(file: Path): FileStamp? = try {
            val read = Files.readAttributes(file, BasicFileAttributes::class.java)
            FileStamp(read.lastModifiedTime(), read.size(), read.fileKey())
        } catch (_: IOException) {
            null
        }
    }
}
