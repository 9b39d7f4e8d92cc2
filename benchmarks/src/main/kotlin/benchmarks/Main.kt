package benchmarks

import benchmarks.boards.BoardHost
import benchmarks.boards.BoardsCourse
import benchmarks.boards.ManyBoards
import benchmarks.boards.REACTIONS
import benchmarks.boards.boards
import benchmarks.boards.hostBoards
import benchmarks.boards.stopThree
import benchmarks.ros.ros
import benchmarks.stops.stops
import java.io.File
import kotlin.system.exitProcess

/** Runs the benchmark that the first argument names and prints its figures; some take a file for all their results. */
fun main(args: Array<String>) {
    when (args.firstOrNull()) {
        "latency" -> latency()
        "filters" -> filters(File(args.getOrElse(1) { "filters.json" }))
        "realtime" -> realtime(File(args.getOrElse(1) { "realtime.json" }))
        "stops" -> if (!stops(File(args.getOrElse(1) { "stops.txt" }))) exitProcess(1)
        "bounds" -> if (!bounds()) exitProcess(1)
        "faults" -> if (!faults()) exitProcess(1)
        "boards" -> if (!boards(File(args.getOrElse(1) { "boards.txt" }))) exitProcess(1)
        "tls" -> tls()
        "ros" -> if (!ros()) exitProcess(1)
        "explore" -> if (!explored(args.getOrNull(2))) exitProcess(1)
        "soak" -> if (!soak()) exitProcess(1)
        "record" -> if (!recorded()) exitProcess(1)
        REPLAY -> replayRecordings(args.drop(1))
        Crowd.NAME -> Crowd().run()
        BoardsCourse.NAME -> BoardsCourse(args[1].toInt(), args[2].toInt()).run()
        REACTIONS -> stopThree(File(args.getOrElse(1) { "boards.txt" }))
        ManyBoards.NAME -> ManyBoards().run()
        BoardHost.NAME -> hostBoards(args.drop(1))
        LATENCY_COURSE -> latencyCourse(args[1])
        else -> {
            System.err.println("usage: ./argo bench latency|stops|boards|filters|realtime|bounds|faults|soak|tls|ros|explore|record")
            exitProcess(2)
        }
    }
    exitProcess(0) // Jason's scheduler would keep the program alive
}
