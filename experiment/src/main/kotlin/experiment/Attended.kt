package experiment

import samples.project.Logs
import samples.project.Progress
import sun.misc.Signal
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption

/**
 * Does [work]. The parameter `show` of [work] writes a line of progress. The log of Jason, ARGO and the agents is written to `log.txt` in
 * [directory]. Ctrl-C aborts the experiment through [given].
 */
internal fun <T> attended(directory: Path, given: GivenUp, work: (show: (List<String>) -> Unit, punctuality: Punctuality) -> T): T {
    val progress = Progress.onStandardOutput()
    listOf("INT", "TERM").forEach { Signal.handle(Signal(it)) { given.giveUp() } }
    val begin = System.nanoTime()
    val file = Files.newOutputStream(directory.resolve("log.txt"), StandardOpenOption.CREATE, StandardOpenOption.APPEND)
    try {
        return PrintStream(file, true, Charsets.UTF_8).use { log ->
            Logs.to(log)
            Punctuality().use { work({ facts -> progress.show(facts, System.nanoTime() - begin) }, it) }
        }
    } finally {
        progress.end()
    }
}

/** Describes this machine for a report. [atOnce] is the number of simultaneous runs, in words. */
internal fun machine(atOnce: String): String =
    listOf("os.name", "os.arch", "java.vm.name", "java.version").joinToString(" ", transform = System::getProperty)
        .let { "$atOnce on ${Runtime.getRuntime().availableProcessors()} processors, $it." }

/** Returns the version and the commit of ARGO. A program without a jar takes them from the property `argo.build`. */
internal fun build(): String =
    System.getProperty("argo.build") ?: Punctuality::class.java.`package`.implementationVersion ?: "of an unknown version"
