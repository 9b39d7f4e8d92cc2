package argo.packing

import org.objectweb.asm.ClassReader
import org.objectweb.asm.ClassWriter
import org.objectweb.asm.Opcodes
import org.objectweb.asm.commons.ClassRemapper
import org.objectweb.asm.commons.Remapper

/**
 * Renames the classes of libraries. A project can then use another version of such a library. Class names in strings, for reflection,
 * stay as they are.
 * @param own the prefixes of names that stay as they are
 * @param into the prefix that is added to all other names
 */
class Relocation(sources: List<Source>, own: List<String>, private val into: String) {
    private val relocated = sources.flatMap { it.classes }.filterNot { name -> own.any { name.startsWith(it) } }.toSet()

    /** Returns the new name of the class [name]. Both are internal names, such as `java/lang/String`. */
    fun of(name: String): String = if (name in relocated) into + name else name

    /**
     * Returns true if all classes of [source] get new names. The source's files in `META-INF` for compilers and shrinkers are then wrong.
     */
    fun isWhole(source: Source): Boolean = source.classes.isNotEmpty() && relocated.containsAll(source.classes)

    /** Returns the class file [bytes] with the new names. Returns [bytes] itself if no name in it changes. */
    fun rename(bytes: ByteArray): ByteArray {
        var renamed = false
        val remapper = object : Remapper(Opcodes.ASM9) {
            override fun map(name: String): String = of(name).also { if (it != name) renamed = true }
        }
        val writer = ClassWriter(0)
        ClassReader(bytes).accept(ClassRemapper(writer, remapper), 0)
        return if (renamed) writer.toByteArray() else bytes
    }
}
