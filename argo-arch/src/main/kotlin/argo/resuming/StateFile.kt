package argo.resuming

import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.READ
import java.nio.file.StandardOpenOption.TRUNCATE_EXISTING
import java.nio.file.StandardOpenOption.WRITE
import java.time.LocalDateTime
import java.time.format.DateTimeFormatter

/**
 * The file that keeps the state of one agent. The file is replaced as a whole. Even if the program or the computer fails, the file is
 * either the old one or the new one. Functions wait for the disk, and throw [IOException].
 */
internal class StateFile private constructor(private val path: Path, private val lock: FileChannel?) : AutoCloseable {
    private val next = path.resolveSibling("${path.fileName}.new")

    /** Returns the file's text; null if the file does not exist. */
    fun read(): String? = if (Files.notExists(path)) null else Files.readString(path)

    /** Puts [text] in place of the file's text. */
    fun exchange(text: String) {
        FileChannel.open(next, WRITE, CREATE, TRUNCATE_EXISTING).use { file ->
            val bytes = Charsets.UTF_8.encode(text)
            while (bytes.hasRemaining()) file.write(bytes)
            file.force(true)
        }
        Files.move(next, path, ATOMIC_MOVE, REPLACE_EXISTING)
        forceFolder()
    }

    /** Makes the disk keep the renaming. Windows opens no folders, so it cannot do this. */
    private fun forceFolder() {
        try {
            FileChannel.open(path.parent, READ).use { it.force(true) }
        } catch (_: IOException) {
            // the text is kept, and the next exchange tries again
        }
    }

    /** Renames the file, so that nothing overwrites it. Returns its new name. */
    fun setAside(): Path = Files.move(path, path.resolveSibling("${path.fileName}.broken-${LocalDateTime.now().format(STAMP)}")).fileName

    /** Releases the file, so that another agent can reserve it. */
    override fun close() = synchronized(TAKEN) {
        TAKEN.remove(path)
        lock?.close() ?: Unit
    }

    override fun toString() = "${path.fileName}"

    companion object {
        private val TAKEN = HashSet<Path>()
        private val STAMP = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss-SSS")

        /** Reserves the file at the absolute [path] for an agent; null if another agent, of this or another program, has reserved it. */
        fun take(path: Path): StateFile? = synchronized(TAKEN) {
            if (path in TAKEN) return null
            val lock = openLock(path)
            if (lock != null && !isLocked(lock)) return null.also { lock.close() }
            TAKEN.add(path)
            StateFile(path, lock)
        }

        /**
         * Opens a second file for the lock, since the state's own file is replaced. If the folder cannot be written, returns null. Each
         * attempt to write a state then reports the trouble.
         */
        private fun openLock(path: Path): FileChannel? = try {
            FileChannel.open(path.resolveSibling("${path.fileName}.lock"), WRITE, CREATE)
        } catch (_: IOException) {
            null
        }

        /** Locks the file of [channel] until [channel] is closed or the program ends. Returns false if another program has locked it. */
        private fun isLocked(channel: FileChannel): Boolean = try {
            channel.tryLock() != null
        } catch (_: OverlappingFileLockException) {
            false // another copy of this class has locked it
        } catch (_: IOException) {
            true // the file system has no locks
        }
    }
}
