package argo.packing

import java.nio.file.Path
import java.time.LocalDateTime
import java.util.jar.Attributes
import java.util.jar.JarEntry
import java.util.jar.JarOutputStream
import java.util.jar.Manifest
import kotlin.io.path.createParentDirectories
import kotlin.io.path.outputStream

private const val SERVICES = "META-INF/services/"

/**
 * Files to leave out, because they are valid only in their own jar: signatures, module descriptors, classes for newer Java, build
 * records.
 */
private val LEFT_OUT = Regex("""META-INF/(MANIFEST\.MF|INDEX\.LIST|[^/]+\.(SF|RSA|DSA|EC)|(versions|maven)/.*)|module-info\.class""")
private val LICENCES = Regex("""META-INF/.*(LICEN[CS]E|NOTICE|COPYING)[^/]*""", RegexOption.IGNORE_CASE)

/**
 * Returns the entries of one jar with the content of all [sources]. Merges service files with the same name. Keeps only the first of
 * other files with the same name.
 */
fun pack(sources: List<Source>, relocation: Relocation): Map<String, ByteArray> {
    val packed = sortedMapOf<String, ByteArray>()
    val providers = sortedMapOf<String, MutableSet<String>>()
    for (source in sources) {
        val library = relocation.isWhole(source)
        for ((name, bytes) in source.entries) {
            when {
                LEFT_OUT.matches(name) -> {}
                name.startsWith(SERVICES) -> {
                    val service = SERVICES + relocation.ofBinary(name.removePrefix(SERVICES))
                    providers.getOrPut(service, ::linkedSetOf) += providers(bytes).map(relocation::ofBinary)
                }
                name.endsWith(".class") ->
                    packed.putIfAbsent("${relocation.of(name.removeSuffix(".class"))}.class", relocation.rename(bytes))
                library && name.startsWith("META-INF/") && !LICENCES.matches(name) -> {}
                else -> packed.putIfAbsent(name, bytes)
            }
        }
    }
    return packed + providers.mapValues { (_, names) -> names.joinToString("") { "$it\n" }.toByteArray() }
}

/** Writes [entries] and a manifest with [attributes] into [jar]. Equal arguments always give the same bytes. */
fun writeJar(jar: Path, attributes: Map<String, String>, entries: Map<String, ByteArray>) {
    val manifest = Manifest().apply {
        mainAttributes[Attributes.Name.MANIFEST_VERSION] = "1.0"
        attributes.forEach { (name, value) -> mainAttributes.putValue(name, value) }
    }
    jar.createParentDirectories()
    JarOutputStream(jar.outputStream().buffered()).use { out ->
        fun entry(name: String, write: () -> Unit) {
            out.putNextEntry(JarEntry(name).apply { timeLocal = WRITTEN })
            write()
            out.closeEntry()
        }
        entry("META-INF/MANIFEST.MF") { manifest.write(out) }
        entries.toSortedMap().forEach { (name, bytes) -> entry(name) { out.write(bytes) } }
    }
}

/** The time stamp of all entries. The jars of the modules have the same time stamp. */
private val WRITTEN = LocalDateTime.of(2026, 1, 1, 0, 0)

private fun Relocation.ofBinary(name: String): String = of(name.replace('.', '/')).replace('/', '.')

/** Returns the classes that a service file names. */
internal fun providers(bytes: ByteArray): List<String> =
    bytes.decodeToString().lines().map { it.substringBefore('#').trim() }.filter { it.isNotEmpty() }
