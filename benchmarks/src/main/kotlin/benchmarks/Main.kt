package benchmarks

import java.io.File
import kotlin.system.exitProcess

/** `latency`, `filters`, `realtime` or `soak`, and for the second and third the file for all results: prints the figures. */
fun main(args: Array<String>) {
    when (args.firstOrNull()) {
        "latency" -> latency()
        "filters" -> filters(File(args.getOrElse(1) { "filters.json" }))
        "realtime" -> realtime(File(args.getOrElse(1) { "realtime.json" }))
        "soak" -> if (!soak()) exitProcess(1)
        Crowd.NAME -> Crowd().run()
        LATENCY_COURSE -> latencyCourse(args[1])
        else -> {
            System.err.println("usage: ./argo bench latency|filters|realtime|faults|soak")
            exitProcess(2)
        }
    }
    exitProcess(0) // Jason's scheduler would keep the program alive
}
