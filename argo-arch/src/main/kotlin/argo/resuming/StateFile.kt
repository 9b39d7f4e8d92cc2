package argo.resuming

import java.io.IOException
import java.nio.channels.FileChannel
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
 * The file that keeps the state of one agent. The file is exchanged as a whole: whatever ends the program or the computer, the file is
 * either the old one or the new one. Functions wait for the disk, and throw [IOException].
 */
internal class StateFile private constructor(private val path: Path) : AutoCloseable {
    private val next = path.resolveSibling("${path.fileName}.new")

    /** Returns the file's text; null: there is no such file. */
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

    /** Makes the disk keep the exchange, as far as the system can: Windows opens no folders. */
    private fun forceFolder() {
        try {
            FileChannel.open(path.parent, READ).use { it.force(true) }
        } catch (_: IOException) {
            // the text is kept, and the next exchange tries again
        }
    }

    /** Renames the file, so that nothing overwrites it. Returns its new name. */
    fun setAside(): Path = Files.move(path, path.resolveSibling("${path.fileName}.broken-${LocalDateTime.now().format(STAMP)}")).fileName

    /** Lets another agent have the file. */
    override fun close() {
        synchronized(TAKEN) { TAKEN.remove(path) }
    }

    override fun toString() = "${path.fileName}"

    companion object {
        private val TAKEN = HashSet<Path>()
        private val STAMP = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss-SSS")

        /** Takes the file at the absolute [path] for an agent; null: another agent of this program has it. */
        fun take(path: Path): StateFile? = synchronized(TAKEN) { if (TAKEN.add(path)) StateFile(path) else null }
    }
}
