package benchmarks.boards

import benchmarks.machine
import benchmarks.stops.Bench
import benchmarks.stops.StopCourse
import java.io.File
import java.util.Locale

private const val STOPS = 60
private const val SEED = 1L
private val BAUDS = listOf(9_600, 57_600, 115_200)

/**
 * Measures one agent on several boards, and prints the figures; writes the timelines of the worst reactions to [timelines]. Returns false
 * if the firmware has not been built.
 */
fun boards(timelines: File): Boolean {
    if (!Bench.isBuilt(BAUDS.map { StopCourse(it) })) {
        System.err.println("there is no simulator, or not all robots: make -C javino-arduino bench; ./argo firmware installs what it needs")
        return false
    }
    println("one agent, several boards, ${machine()}")
    senseSeveral()
    senseMany()
    stopThree(timelines)
    return true
}

private fun senseSeveral() {
    println("pseudo-terminals, all percepts change, 50 Hz, 20 s after 40 s; boards in another process")
    var one = Double.NaN
    for (course in listOf(BoardsCourse(1, 12), BoardsCourse(8, 3), BoardsCourse(8, 12))) {
        val result = course.measure()
        if (course.boards == 1) one = result.processor
        println(
            (
                "%-28s sensed at %.1f %% of the rate or more, perceived at %.1f %%; " +
                    "skew: median %.2f ms, 99th percentile %.2f ms, longest %.1f ms"
                ).format(Locale.ROOT, "$course:", result.leastSensed * 100, result.leastPerceived * 100, *result.skewMs.toTypedArray()),
        )
        println(
            "%-28s %.1f %% of a processor, %.1f times that of the first: %s".format(
                Locale.ROOT, "", result.processor * 100, result.processor / one,
                result.processorOf.entries.joinToString { (group, share) -> "%s %.1f %%".format(Locale.ROOT, group.title, share * 100) },
            ),
        )
    }
}

private fun senseMany() = with(ManyBoards().measure()) {
    println(
        ("${ManyBoards.BOARDS} boards over TCP at 5 Hz: sensed at %.1f %% of the rate or more; %d of %d answers lost; " +
            "heap %.0f MB, %.0f KB a board; process %.0f MB; %d threads, %.1f a board; all perceived after %.0f ms; " +
            "closed after %.0f ms").format(
            Locale.ROOT, leastSensed * 100, lost, messages, heapMb, heapMb * 1024 / ManyBoards.BOARDS, residentMb, threads,
            threads.toDouble() / ManyBoards.BOARDS, openingMs, closingMs,
        ),
    )
}

/** The name of the program that measures only the reactions. */
internal const val REACTIONS = "boards-reactions"

/**
 * Measures how soon an agent on three boards reacts, and prints the figures; writes the timelines of the worst reactions to [timelines].
 */
internal fun stopThree(timelines: File) {
    println("simulated Unos, twelve percepts that all change, interval 20 ms, virtual time: from the limit to the stop, $STOPS each; ms")
    println("%-36s %s".format("", BAUDS.joinToString("   ") { "%26s".format("$it baud") }))
    timelines.writeText("")
    val alone = BAUDS.associateWith { baud -> Trio(listOf(baud)).use { it.stop(STOPS, SEED).getValue(baud) } }
    show("alone", alone, alone, timelines)
    show("together", Trio(BAUDS).use { it.stop(STOPS, SEED) }, alone, timelines)
    for (trouble in Trouble.entries) for (baud in BAUDS) {
        val reactions = Trio(BAUDS).use { trio ->
            trio.have(trouble, baud)
            trio.stop(STOPS, SEED)
        }
        show("the one of $baud baud ${trouble.title}", reactions, alone, timelines)
    }
    println("the worst of each: $timelines")
}

private fun show(what: String, reactions: Map<Int, Reactions>, alone: Map<Int, Reactions>, timelines: File) {
    val cells = BAUDS.map { baud -> reactions[baud]?.let { cell(it, alone.getValue(baud)) }.orEmpty() }
    println("%-36s %s".format(what, cells.joinToString("   ") { "%26s".format(it) }))
    reactions.forEach { (baud, one) -> timelines.appendText("$what: the worst at $baud baud, ms from the limit on\n${one.worst}\n") }
}

private fun cell(reactions: Reactions, alone: Reactions) = with(reactions.distribution) {
    "%.1f, longest %.1f (%+.0f %%)".format(Locale.ROOT, ms(0.5), ms(1.0), (ms(0.5) / alone.distribution.ms(0.5) - 1) * 100)
}
