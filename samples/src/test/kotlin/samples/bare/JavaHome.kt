package samples.bare

import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** An installed Java: the path of its program and its feature version, such as 17. */
data class InstalledJava(val program: String, val feature: Int)

fun thisJava() = InstalledJava(Path.of(System.getProperty("java.home"), "bin", "java").toString(), Runtime.version().feature())

/** Finds the newest Java on this machine in `JAVA_HOME…` variables and in the folders of Linux distributions and SDKMAN. */
fun newestJava(): InstalledJava {
    val named = System.getenv().filterKeys { it.startsWith("JAVA_HOME") }.values.map(Path::of)
    val installed =
        listOf(Path.of("/usr/lib/jvm"), Path.of(System.getProperty("user.home"), ".sdkman/candidates/java")).filter(Files::isDirectory)
            .flatMap { folder -> Files.list(folder).use { it.toList() } }
    return (named + installed).map { it.resolve("bin/java") }.filter(Files::isExecutable)
        .mapNotNull { java -> feature(java.toString())?.let { InstalledJava(java.toString(), it) } }
        .plus(thisJava()).maxBy { it.feature }
}

private fun feature(java: String): Int? {
    val process = ProcessBuilder(java, "-version").redirectErrorStream(true).start()
    val text = process.inputStream.bufferedReader().readText()
    if (!process.waitFor(60, TimeUnit.SECONDS)) process.destroyForcibly()
    return Regex("""version "(\d+)""").find(text)?.groupValues?.get(1)?.toInt()
}
