package benchmarks

import java.io.File

/** The machine that a figure was measured on, in a few words. */
fun machine(): String =
    "${Runtime.getRuntime().availableProcessors()} processors, Java ${Runtime.version().feature()}, ${System.getProperty("os.name")} " +
        "${System.getProperty("os.arch")}"

/** The memory that this process has resident, in MB: `VmRSS` now, `VmHWM` at most so far. NaN where it is not known, as beside Linux. */
internal fun residentMb(figure: String): Double {
    val status = File("/proc/self/status")
    if (!status.exists()) return Double.NaN
    return status.readLines().first { it.startsWith(figure) }.filter(Char::isDigit).toDouble() / 1024
}
