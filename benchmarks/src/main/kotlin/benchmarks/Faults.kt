package benchmarks

import javino.virtual.FaultyExchanges
import javino.virtual.RandomFaults

private const val EXCHANGES = 1_000_000
private val RATES = listOf(1e-5, 1e-4, 1e-3)

/**
 * Makes a million version 2 exchanges at each rate of wrong bits, and prints the outcomes. Half of them are commands, and half are
 * requests. Virtual time makes the figures equal on every machine. Returns true if each command was carried out in order and at most once,
 * and each confirmed command was carried out.
 */
internal fun faults(): Boolean {
    println("version 2, 115,200 baud, $EXCHANGES exchanges at each rate: half of them commands, half requests with 500 ms for the answer")
    val heads = listOf("wrong bits", "confirmed", "twice", "wrong", "answered", "dropped", "wrongly believed")
    println(figures("%-12s %12s %8s %8s %12s %12s %16s", *heads.toTypedArray()))
    return RATES.map(::faultsAt).all { it }
}

private fun faultsAt(rate: Double): Boolean {
    val outcomes = FaultyExchanges(EXCHANGES, RandomFaults(rate, seed = 2026), RandomFaults(rate, seed = 7))
    val half = EXCHANGES / 2.0
    println(
        figures(
            "%-12s %10.4f %% %8d %8d %10.4f %% %12d %16d", figures("1 in %,d", Math.round(1 / rate)), 100 * outcomes.confirmations / half,
            outcomes.twice, outcomes.wrong.size, 100 * outcomes.answered / half, outcomes.corruptFrames, outcomes.corruptBelieved.size,
        ),
    )
    outcomes.wrong.take(SHOWN).forEach { println("  $it") }
    return outcomes.twice == 0 && outcomes.wrong.isEmpty()
}

private const val SHOWN = 10
