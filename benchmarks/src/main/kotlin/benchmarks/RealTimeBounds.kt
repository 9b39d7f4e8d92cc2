package benchmarks

import javino.virtual.BoardTimes
import javino.virtual.Bounded
import javino.virtual.BoundsCase
import javino.virtual.BoundsRun
import javino.virtual.Closest
import javino.virtual.checkBounds
import kotlin.random.Random

private const val EXCHANGES = 1_000_000
private const val EXCHANGES_OF_AN_EXAMPLE = 20_000
private const val SEED = 1L

/**
 * Makes a million exchanges on random lines, boards and intervals. Prints how close each came to its bound. Also prints the longest
 * exchanges for the examples in docs/real-time.md. Virtual time makes the figures equal on every machine. Returns true if no exchange
 * exceeded its bound.
 */
internal fun bounds(): Boolean {
    val closest = checkBounds(EXCHANGES, SEED)
    println("$EXCHANGES exchanges on random lines and boards, virtual time: closest to its bound")
    closest.entries.sortedBy { it.key }.forEach { (what, found) -> println(row(what, found)) }
    for (baud in listOf(9_600, 115_200)) for (hasRules in listOf(false, true)) {
        val board = if (hasRules) "rules on the board" else "no rules on the board"
        println("the example at $baud baud, $board: the longest of $EXCHANGES_OF_AN_EXAMPLE exchanges")
        val random = Random(SEED)
        val run = BoundsRun(BoundsCase(baud, EXAMPLE, intervalMs = 50, percepts = 10, digits = 3, hasRules), random)
        run.use { while (it.exchanges < EXCHANGES_OF_AN_EXAMPLE) it.step() }
        run.closest.entries.sortedBy { it.key }.forEach { (what, found) -> println(row(what, found)) }
    }
    return closest.values.none { it.share > 1 }
}

private val EXAMPLE = BoardTimes(loop = 5_000_000, action = 1_000_000, sensors = 6_000_000, ruleSensors = 2_000_000, isSteady = false)

private fun row(what: Bounded, found: Closest) = figures(
    "  %-64s %6.1f %% %10.3f of %.3f ms", what.words, 100 * found.share, found.measured / NANOS_PER_MS, found.bound / NANOS_PER_MS,
)

private const val NANOS_PER_MS = 1e6
