package argo.watching

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.BasicFileAttributes
import java.nio.file.attribute.FileTime

/**
 * Notices that files have been saved, by looking at them again and again. A file counts as saved when it has changed and then stayed the
 * same from one look to the next, since many editors write a file in several steps. Not safe for use by several threads.
 *
 * @param stampOf returns the state of a file; null: it cannot be read
 */
internal class SavedFiles(private val stampOf: (Path) -> FileStamp? = FileStamp::of) {
    private var taken: Map<Path, FileStamp?> = emptyMap()
    private var seen: Map<Path, FileStamp?> = emptyMap()

    /**
     * Looks at [files], and returns those that have been saved since they were last returned. Files that were not in the last look count as
     * unchanged.
     */
    fun look(files: Collection<Path>): List<Path> {
        val now = files.associateWith(stampOf)
        val saved = files.filter { now[it] == seen[it] && it in taken && now[it] != taken[it] }
        taken = now.mapValues { (file, stamp) -> if (file in saved || file !in taken) stamp else taken[file] }
        seen = now
        return saved
    }

    companion object {
        /** The time between two looks. */
        const val LOOK_EACH_MS = 250L
    }
}

/**
 * The state of a file, which differs after each change.
 *
 * @property key identifies the file itself, since an editor may put a new one in its place; null: the file system has no such key
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
