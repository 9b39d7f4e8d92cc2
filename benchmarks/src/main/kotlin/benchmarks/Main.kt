package benchmarks

import java.io.File
import kotlin.system.exitProcess

/** `latency`, `filters` or `realtime`, and for the latter two the file for all results: prints the figures. */
fun main(args: Array<String>) {
    when (args.firstOrNull()) {
        "latency" -> latency()
        "filters" -> filters(File(args.getOrElse(1) { "filters.json" }))
        "realtime" -> realtime(File(args.getOrElse(1) { "realtime.json" }))
        Crowd.NAME -> Crowd().run()
        else -> {
            System.err.println("usage: ./argo bench latency|filters|realtime|faults|soak")
            exitProcess(2)
        }
    }
    exitProcess(0) // Jason's scheduler would keep the program alive
}
