package benchmarks

import com.sun.management.OperatingSystemMXBean
import java.io.File
import java.lang.management.ManagementFactory

fun machine(): String =
    "${Runtime.getRuntime().availableProcessors()} processors, Java ${Runtime.version().feature()}, ${System.getProperty("os.name")} " +
        "${System.getProperty("os.arch")}"

/**
 * Returns the resident memory of the [process] in MB. `VmRSS` is the current memory, and `VmHWM` the greatest up to now. Returns NaN if the
 * memory is not known. Only Linux tells it.
 */
internal fun residentMb(figure: String, process: String = "self"): Double {
    val status = File("/proc/$process/status")
    if (!status.exists()) return Double.NaN
    return status.readLines().first { it.startsWith(figure) }.filter(Char::isDigit).toDouble() / 1024
}

internal fun processNanos(): Long = (ManagementFactory.getOperatingSystemMXBean() as OperatingSystemMXBean).processCpuTime
