package benchmarks

import java.io.File
import java.util.concurrent.TimeUnit

/**
 * Runs this program with [arguments] in a new Java process, and returns the numbers in its last line.
 *
 * @throws IllegalStateException if the program fails, or prints no numbers
 */
internal fun figuresApart(vararg arguments: String, options: List<String> = emptyList()): List<Double> {
    val process = programApart(*arguments, options = options)
    val last = process.inputStream.bufferedReader().readLines().lastOrNull().orEmpty()
    val figures = last.split(' ').map(String::toDoubleOrNull)
    check(process.waitFor(ENDING_S, TimeUnit.SECONDS) && process.exitValue() == 0 && null !in figures) {
        "${arguments.joinToString(" ")} ended with \"$last\"${if (process.isAlive) ", and runs on" else ""}"
    }
    return figures.filterNotNull()
}

/** Starts this program with [arguments] in a new Java process. The errors of the new process appear among those of this process. */
internal fun programApart(vararg arguments: String, options: List<String> = emptyList()): Process {
    val java = listOf(File(System.getProperty("java.home"), "bin/java").path, "--enable-native-access=ALL-UNNAMED")
    val program = listOf("-cp", System.getProperty("java.class.path"), "benchmarks.MainKt")
    return ProcessBuilder(java + options + program + arguments).redirectError(ProcessBuilder.Redirect.INHERIT).start()
}

private const val ENDING_S = 120L
