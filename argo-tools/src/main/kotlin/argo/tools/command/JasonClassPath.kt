package argo.tools.command

import java.io.File
import java.io.PrintWriter
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries

internal fun hasJason(): Boolean = try {
    Class.forName("jason.asSemantics.Agent", false, ToolException::class.java.classLoader)
    true
} catch (_: ClassNotFoundException) {
    false
}

/**
 * Java options for programs that run for seconds. A short program ends before better compilation helps, and needs no threads for garbage
 * collection. Java ignores unknown ones of these options.
 */
internal val QUICK_START = listOf("-XX:+IgnoreUnrecognizedVMOptions", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC")

/** Tells the user which parts of the option [classPath] do not exist. Java would ignore them silently. */
internal fun tellAbsent(classPath: String?, err: PrintWriter) {
    val absent = classPath.orEmpty().split(File.pathSeparator).filterNot { it.isEmpty() || File(it.removeSuffix("*")).exists() }
    if (absent.isNotEmpty()) err.println("of --class-path there is no ${absent.joinToString(" and no ")}")
}

/**
 * Returns the class path of this program with [classPath] and Jason added, or null if there is no Jason. An entry that ends in `*` means
 * all jars of a folder.
 */
fun classPathWithJason(classPath: String?): String? {
    val jason = if (hasJason()) null else ownJar()?.let { Installation(it).jason() }
    if (classPath == null && jason == null && !hasJason()) return null
    return listOfNotNull(System.getProperty("java.class.path"), classPath, jason).joinToString(File.pathSeparator)
}

/** Returns the folders and jars on [classPath]. Expands `folder/`+`*`, since only Java understands it. Kotlin's compiler does not. */
fun filesOn(classPath: String): List<Path> = classPath.split(File.pathSeparator).filter { it.isNotEmpty() }.flatMap { entry ->
    val folder = entry.removeSuffix("*")
    if (entry == folder) listOf(Path.of(entry))
    else Path.of(folder).takeIf { it.isDirectory() }?.listDirectoryEntries("*.jar").orEmpty()
}

/** Returns the message that [work] needs Jason. The message mentions the class folders in [project]. */
internal fun missingJason(work: String = "a replay", project: Path = Path.of("")): String {
    val built = listOf("target/classes" to "Maven", "build/classes/java/main" to "Gradle")
    val there = built.filter { (folder, _) -> project.resolve(folder).isDirectory() }
    val examples = there.ifEmpty { built }.joinToString(" or ") { (folder, build) ->
        "--class-path '${listOf("jason/*", folder).joinToString(File.pathSeparator)}'" + if (there.isEmpty()) " of $build" else ""
    }
    return "$work runs Jason, which argo.jar does not hold: --class-path names its jars and the project's classes, such as $examples"
}
