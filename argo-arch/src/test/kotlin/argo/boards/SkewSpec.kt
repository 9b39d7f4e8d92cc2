package argo.boards

import argo.acting.CommandLedger
import argo.perception.FreshHandOver
import argo.perception.Snapshot
import argo.perception.UnfinishedWork
import argo.sensing.SensingInstants
import io.kotest.core.spec.style.FunSpec
import java.util.concurrent.TimeUnit
import kotlin.random.Random

/** A board that is asked at the instants of its interval, or as soon as it has answered. The board answers within its longest delay. */
private class AskedBoard(private val random: Random, begins: Long) {
    private val intervalNanos = ms(listOf(0, 5, 20, 50, 100, 250).random(random))
    private val longestNanos = ms(random.nextInt(1, 200))
    private val handOver = FreshHandOver(UnfinishedWork(CommandLedger { null }, nowMs = { 0 }))
    private var askedNanos = begins + random.nextLong(longestNanos)

    /** The time at which the board's next answer arrives. */
    var arrivesNanos = askedNanos + random.nextLong(longestNanos)
        private set

    /** The time at which the believed percepts arrived; null if none is believed yet. */
    var believedNanos: Long? = null
        private set

    /** The greatest possible age of the board's percepts at their hand-over. */
    val boundNanos = intervalNanos + longestNanos

    fun answers() {
        handOver.put(Snapshot(null, emptyList(), emptyList(), emptyList(), arrivesNanos))
        askedNanos = maxOf(SensingInstants.after(askedNanos, intervalNanos), arrivesNanos)
        arrivesNanos = askedNanos + random.nextLong(longestNanos + 1)
    }

    fun isPerceived(): Boolean = handOver.take()?.also { believedNanos = it.receivedNanos } != null
}

private fun ms(ms: Int) = TimeUnit.MILLISECONDS.toNanos(ms.toLong())

class SkewSpec : FunSpec({
    val snapshots = Integer.getInteger("argo.skew.snapshots", 20_000)

    test("what is handed over is never further apart than the longest interval and the longest answer of a board") {
        var handedOver = 0
        var seed = 0
        while (handedOver < snapshots) {
            val random = Random(seed++)
            var now = random.nextLong(ms(10_000))
            val boards = List(random.nextInt(1, 9)) { AskedBoard(random, now) }
            val bound = boards.maxOf { it.boundNanos }
            repeat(1_000) {
                now += random.nextLong(ms(listOf(1, 10, 100, 1_000).random(random)))
                while (true) (boards.minBy { it.arrivesNanos }.takeIf { it.arrivesNanos <= now } ?: break).answers()
                if (boards.count { it.isPerceived() } > 0) handedOver++
                val believed = boards.mapNotNull { it.believedNanos }
                val skew = if (believed.isEmpty()) 0 else believed.max() - believed.min()
                check(skew <= bound) { "seed ${seed - 1}: $skew ns of $bound" }
            }
        }
    }
})
