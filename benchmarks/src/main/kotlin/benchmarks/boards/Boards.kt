package benchmarks.boards

import benchmarks.figures
import benchmarks.machine
import benchmarks.stops.Bench
import benchmarks.stops.StopCourse
import java.io.File

private const val STOPS = 60
private const val SEED = 1L
private val BAUDS = listOf(9_600, 57_600, 115_200)

/**
 * Measures one agent on several boards, and prints the figures. Writes the timelines of the worst reactions to [timelines]. Returns false
 * if the firmware has not been built.
 */
fun boards(timelines: File): Boolean {
    if (!Bench.isBuilt(BAUDS.map { StopCourse(it) })) {
        System.err.println("there is no simulator, or not all robots: make -C javino-arduino bench; ./argo firmware installs what it needs")
        return false
    }
    println("one agent, several boards, ${machine()}")
    senseSeveral()
    println(sensedMany())
    stopThree(timelines)
    return true
}

/**
 * Measures how fast an agent on three boards reacts, and prints the figures. Writes the timelines of the worst reactions to [timelines].
 */
private fun stopThree(timelines: File) {
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
    figures("%.1f, longest %.1f (%+.0f %%)", ms(0.5), ms(1.0), (ms(0.5) / alone.distribution.ms(0.5) - 1) * 100)
}
