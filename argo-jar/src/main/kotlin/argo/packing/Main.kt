package argo.packing

import java.io.File
import java.nio.file.Path
import kotlin.system.exitProcess

/** Packages that keep their names: ARGO's own, Kotlin's standard library, and jSerialComm, whose native libraries name its classes. */
internal val OWN_NAMES =
    listOf("argo/", "javino/", "jason/", "kotlin/", "org/jetbrains/annotations/", "org/intellij/lang/annotations/", "com/fazecast/")

/** Packs argo.jar: both builds run this with JAR VERSION CLASSPATH, so that both jars hold the same. */
fun main(arguments: Array<String>) {
    if (arguments.size != 3) {
        System.err.println("usage: JAR VERSION CLASSPATH, where CLASSPATH is what the jar shall hold")
        exitProcess(2)
    }
    val (jar, version, classPath) = arguments
    val manifest = mapOf(
        "Main-Class" to "argo.tools.MainKt",
        "Enable-Native-Access" to "ALL-UNNAMED", // since jSerialComm loads a native library
        "Implementation-Title" to "ARGO",
        "Implementation-Version" to version,
    )
    val sources = classPath.split(File.pathSeparator).filter { it.isNotEmpty() }.map { Source.read(Path.of(it)) }
    writeJar(Path.of(jar), manifest, pack(sources, Relocation(sources, OWN_NAMES, into = "argo/shaded/")))
}
