package argo.packing

import org.objectweb.asm.ClassReader
import org.objectweb.asm.ClassWriter
import org.objectweb.asm.Opcodes
import org.objectweb.asm.commons.ClassRemapper
import org.objectweb.asm.commons.Remapper

/**
 * Gives the classes of libraries names of their own, so that a project can have another version of the same library.
 * Names in strings, which reflection uses, stay as they are.
 * @param own prefixes of the names that stay
 * @param into the prefix that the other names get
 */
class Relocation(sources: List<Source>, own: List<String>, private val into: String) {
    private val relocated = sources.flatMap { it.classes }.filterNot { name -> own.any { name.startsWith(it) } }.toSet()

    /** Returns the new name of a class; both are internal names, `java/lang/String`. */
    fun of(name: String): String = if (name in relocated) into + name else name

    /** Returns true if all classes of [source] get new names, so that its `META-INF` for compilers and shrinkers is no longer true. */
    fun isWhole(source: Source): Boolean = source.classes.isNotEmpty() && relocated.containsAll(source.classes)

    /** Returns the class file [bytes] with the new names; the same bytes if it uses none of them. */
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
