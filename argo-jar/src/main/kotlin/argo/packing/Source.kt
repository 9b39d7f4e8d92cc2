package argo.packing

import java.nio.file.Path
import java.util.jar.JarFile
import kotlin.io.path.exists
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.readBytes
import kotlin.io.path.relativeTo
import kotlin.io.path.walk

/**
 * One entry of a class path: a jar or a folder.
 * @property entries the files by their paths, with `/` between the parts
 */
class Source(val entries: Map<String, ByteArray>) {
    /** The internal names of the classes, such as `java/lang/String`. */
    val classes: List<String> =
        entries.keys.filter { it.endsWith(".class") && !it.startsWith("META-INF/") }.map { it.removeSuffix(".class") }

    companion object {
        /** Reads the files at [path]. Returns a source without files if [path] does not exist, as in a module without resources. */
        fun read(path: Path): Source = Source(
            when {
                !path.exists() -> emptyMap()
                path.isDirectory() -> folder(path)
                else -> jar(path)
            },
        )

        private fun folder(folder: Path): Map<String, ByteArray> =
            folder.walk().filter { it.isRegularFile() }.associate { it.relativeTo(folder).invariantSeparatorsPathString to it.readBytes() }

        private fun jar(file: Path): Map<String, ByteArray> = JarFile(file.toFile()).use { jar ->
            jar.entries().asSequence().filterNot { it.isDirectory }.associate { it.name to jar.getInputStream(it).readBytes() }
        }
    }
}
