package benchmarks

import kotlin.system.exitProcess

/** `latency`: prints the figures of one benchmark. */
fun main(args: Array<String>) {
    when (args.singleOrNull()) {
        "latency" -> latency()
        else -> {
            System.err.println("usage: ./argo bench latency")
            exitProcess(2)
        }
    }
    exitProcess(0) // Jason's scheduler would keep the program alive
}
