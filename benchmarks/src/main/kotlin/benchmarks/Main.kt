package benchmarks

import benchmarks.stops.stops
import java.io.File
import kotlin.system.exitProcess

/**
 * `latency`, `stops`, `filters`, `realtime`, `bounds`, `faults` or `soak`, and for the second to the fourth the file for all results: prints
 * the figures.
 */
fun main(args: Array<String>) {
    when (args.firstOrNull()) {
        "latency" -> latency()
        "filters" -> filters(File(args.getOrElse(1) { "filters.json" }))
        "realtime" -> realtime(File(args.getOrElse(1) { "realtime.json" }))
        "stops" -> if (!stops(File(args.getOrElse(1) { "stops.txt" }))) exitProcess(1)
        "bounds" -> if (!bounds()) exitProcess(1)
        "faults" -> if (!faults()) exitProcess(1)
        "soak" -> if (!soak()) exitProcess(1)
        Crowd.NAME -> Crowd().run()
        LATENCY_COURSE -> latencyCourse(args[1])
        else -> {
            System.err.println("usage: ./argo bench latency|stops|filters|realtime|bounds|faults|soak")
            exitProcess(2)
        }
    }
    exitProcess(0) // Jason's scheduler would keep the program alive
}
