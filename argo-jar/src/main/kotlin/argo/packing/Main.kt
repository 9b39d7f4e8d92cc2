package argo.packing

import java.io.File
import java.nio.file.Path
import kotlin.system.exitProcess

/**
 * Packages that keep their names: ARGO's own packages, Kotlin's standard library, jSerialComm and JGroups. The native libraries of
 * jSerialComm contain its class names. The tables of JGroups contain its class names.
 */
internal val OWN_NAMES =
    listOf(
        "argo/", "javino/", "jason/", "kotlin/", "org/jetbrains/annotations/", "org/intellij/lang/annotations/", "com/fazecast/",
        "org/jgroups/",
    )

/**
 * Packs a jar. The Maven build and the Gradle build both run this program, so their jars have the same content.
 *
 * The arguments for `argo.jar` are JAR VERSION CLASSPATH. The arguments for `argo-fleet.jar` are JAR VERSION CLASSPATH BESIDE.
 */
fun main(arguments: Array<String>) {
    if (arguments.size !in 3..4) {
        System.err.println("usage: JAR VERSION CLASSPATH [BESIDE], where the jar shall hold CLASSPATH, and argo.jar beside it holds BESIDE")
        exitProcess(2)
    }
    val (jar, version, classPath) = arguments
    val beside = arguments.getOrNull(3)
    val sources = sources(classPath)
    val relocation = Relocation(sources + sources(beside.orEmpty()), OWN_NAMES, into = "argo/shaded/")
    writeJar(Path.of(jar), manifest(version) + if (beside == null) TOOLS else FLEETS, pack(sources, relocation))
}

private val TOOLS = mapOf("Main-Class" to "argo.tools.MainKt")

/** With these attributes, `java -jar argo-fleet.jar` finds `argo.jar` in the same folder. */
private val FLEETS = mapOf("Main-Class" to "argo.fleet.MainKt", "Class-Path" to "argo.jar")

private fun manifest(version: String) = mapOf(
    "Enable-Native-Access" to "ALL-UNNAMED", // jSerialComm loads a native library
    "Implementation-Title" to "ARGO",
    "Implementation-Version" to version,
)

private fun sources(classPath: String): List<Source> =
    classPath.split(File.pathSeparator).filter { it.isNotEmpty() }.map { Source.read(Path.of(it)) }
