package argo.orders

import argo.platform.pathOf
import jason.asSemantics.Agent
import jason.runtime.SourcePath
import java.io.File
import java.io.FileNotFoundException
import java.io.IOException
import java.net.MalformedURLException
import java.net.URL
import java.nio.file.Path

/** A file of a program. [address] is its address for Jason, [bytes] its content. */
class ProgramSource(val address: String, val bytes: ByteArray) {
    val text: String get() = bytes.decodeToString()

    /** The path of the file; null if it is in a jar, on the class path or on another computer. */
    val path: Path? by lazy { pathOf(address) }

    companion object {
        /**
         * Reads the file at [address].
         *
         * @throws IOException if it cannot be read
         */
        fun at(address: String): ProgramSource = ProgramSource(address, open(address).use { it.readBytes() })

        /** Returns Jason's name for the program at [address]: its URL, or the name of its file. */
        fun nameOf(address: String): String = try {
            "${URL(address)}"
        } catch (_: MalformedURLException) {
            File(address).name
        }

        /**
         * Reads the file that a program includes as [name]. Searches for it where Jason does. Returns null if the file is missing; Jason
         * ignores a missing file. [outer] is the address of the including file. It is null if the agent's program includes the file when
         * the agent starts.
         */
        fun included(name: String, outer: String?, sourcePath: SourcePath): ProgramSource? {
            val found = sourcePath.fixPath(name)
            return try {
                at(if (outer == null) found else pathsOf(outer, sourcePath).fixPath(found))
            } catch (_: IOException) {
                null
            }
        }

        /** Returns the paths, on this computer's disks, at which [included] looks for the file. */
        internal fun placesOf(name: String, outer: String?, sourcePath: SourcePath): List<Path> =
            (listOf(name) + pathsOf(outer, sourcePath).paths.map { "$it/$name" }).mapNotNull(::pathOf).distinct()

        private fun pathsOf(outer: String?, sourcePath: SourcePath) = SourcePath().apply {
            if (outer != null) addParentInPath(outer)
            addAll(sourcePath)
        }

        private fun open(address: String) = when {
            address.startsWith(SourcePath.CRPrefix) ->
                Agent::class.java.getResourceAsStream(address.removePrefix(SourcePath.CRPrefix)) ?: throw FileNotFoundException(address)
            else -> try {
                URL(address).openStream()
            } catch (_: MalformedURLException) {
                URL("file:$address").openStream()
            }
        }
    }
}
