package argo.perception

import argo.acting.CommandLedger
import argo.filters.CriticalRule
import argo.filters.Rule
import argo.filters.matching.CriticalPercept
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import javino.interleavings.concurrently
import javino.interleavings.inEachInterleaving

/** Takes an agent's snapshots from [handOver], and checks them. */
private class Perceptions(private val handOver: HandOver) {
    private val taken = ArrayList<Snapshot>() // for the agent's thread and, after its end, for the test's thread

    fun take() {
        val snapshot = handOver.take() ?: return
        val last = taken.lastOrNull()
        check(last == null || last.receivedNanos < snapshot.receivedNanos) {
            "${snapshot.receivedNanos} is taken after ${last?.receivedNanos}"
        }
        taken += snapshot
    }

    /** Takes the snapshots that are left, and returns the times of all. */
    fun all(): List<Long> {
        while (handOver.isReady()) take()
        return taken.map { it.receivedNanos }
    }
}

@Tags("Thorough")
class HandOverInterleavingsSpec : FunSpec({
    val near = listOf(CriticalPercept(CriticalRule(Rule("near")), ASSyntax.parseLiteral("near(9)")))

    fun snapshot(n: Long, critical: List<CriticalPercept<Literal>> = emptyList()) =
        Snapshot(null, emptyList(), emptyList(), emptyList(), n, critical)

    fun fresh() = FreshHandOver(UnfinishedWork(CommandLedger { null }, nowMs = { 0 }))

    /** Puts [snapshots] while the agent takes twice, in all interleavings. [expect] gets the times of all taken snapshots. */
    fun check(handOver: () -> HandOver, vararg snapshots: Snapshot, expect: (List<Long>) -> Boolean) = inEachInterleaving {
        val shared = handOver()
        val agent = Perceptions(shared)
        concurrently({ for (snapshot in snapshots) shared.put(snapshot) }, { repeat(2) { agent.take() } })
        val taken = agent.all()
        check(expect(taken)) { "taken: $taken" }
    }

    test("fresh: the newest snapshot is taken last, and none twice or after a newer one") {
        check(::fresh, snapshot(1), snapshot(2)) { it.last() == 2L }
    }

    test("fresh: a critical snapshot is taken, and none twice or after a newer one") {
        check(::fresh, snapshot(1), snapshot(2, near)) { 2L in it }
        check(::fresh, snapshot(1, near), snapshot(2)) { 1L in it && it.last() == 2L }
    }

    test("every: each snapshot is taken once, in their order") {
        check({ EveryHandOver { error(it) } }, snapshot(1), snapshot(2)) { it == listOf(1L, 2L) }
    }
})
