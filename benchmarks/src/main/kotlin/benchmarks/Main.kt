package benchmarks

import java.io.File
import kotlin.system.exitProcess

/** `latency` or `filters`, and for the latter the file for its whole results: prints the figures. */
fun main(args: Array<String>) {
    when (args.firstOrNull()) {
        "latency" -> latency()
        "filters" -> filters(File(args.getOrElse(1) { "filters.json" }))
        else -> {
            System.err.println("usage: ./argo bench latency|filters")
            exitProcess(2)
        }
    }
    exitProcess(0) // Jason's scheduler would keep the program alive
}
