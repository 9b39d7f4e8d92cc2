package argo.tools.exploring

import argo.tools.command.Installation
import argo.tools.command.ToolException
import argo.tools.command.filesOn
import argo.tools.command.ownJar
import java.io.File
import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.isRegularFile
import kotlin.io.path.name
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readLines

/**
 * Returns [classPath] with the test kit added. In a release, the test kit is beside `argo.jar`. In a source tree, it is in Maven's output
 * folder.
 *
 * @throws ToolException if the test kit is in neither place and not on [classPath]
 */
internal fun withTestKit(classPath: String): String {
    if (filesOn(classPath).any { it.name.startsWith("argo-testkit") || it.resolve("argo/exploring/Exploration.class").isRegularFile() }) {
        return classPath
    }
    val kit = ownJar()?.let { Installation(it).testKit() }
        ?: throw ToolException("an exploration needs the test kit: --class-path names its jar, such as --class-path argo-testkit.jar")
    return "$classPath${File.pathSeparator}$kit"
}

/**
 * Compiles [file] into the folder [classes] with `kotlinc`. Returns the name of the class with the file's functions.
 *
 * @throws ToolException if there is no compiler, or if it refuses the file
 */
internal fun compiled(file: Path, classPath: String, classes: Path): String {
    val path = filesOn(classPath).joinToString(File.pathSeparator)
    val compiler = try {
        ProcessBuilder("kotlinc", "$file", "-classpath", path, "-d", "$classes", "-nowarn").redirectErrorStream(true).start()
    } catch (_: IOException) {
        throw ToolException(
            "there is no kotlinc, which compiles $file (https://kotlinlang.org/docs/command-line.html). Without it, describe the boards " +
                "with --board, or have the project's build compile it and name the class: --boards ${className(file)} --class-path …",
        )
    }
    val said = compiler.inputStream.bufferedReader().readText().trim()
    if (compiler.waitFor() != 0) throw ToolException("kotlinc does not compile $file:\n$said")
    return className(file)
}

private fun className(file: Path): String {
    val inside = file.readLines().firstNotNullOfOrNull { PACKAGE.find(it)?.groupValues?.get(1) }
    return listOfNotNull(inside, "${file.nameWithoutExtension.replaceFirstChar(Char::uppercase)}Kt").joinToString(".")
}

private val PACKAGE = Regex("^package\\s+([\\w.]+)")
