package benchmarks

import javino.Protocol
import java.util.concurrent.atomic.AtomicLongArray
import kotlin.math.min

/**
 * Measures the age of the newest snapshot when an intention acts on it. The age is the time from the last byte of an answer to the first
 * action of a plan for its percept. All [sensors] change in each answer, and each change is an event. The agent has [plans] plans for each
 * event. Only the last one applies.
 */
internal fun snapshotAge(sensors: Int, plans: Int): Distribution {
    val receivedAt = AtomicLongArray(MAX_ACTIONS)
    val ages = AgeMeter(receivedAt)
    val board = SensorBoard(
        Protocol.AUTO, { n -> (1..sensors).joinToString("") { "s($it,$n);" } },
        { n, endNanos, _ -> receivedAt.set(n % MAX_ACTIONS, endNanos) },
    )
    acts.heard = { n, nanos, _ -> ages.heard(n, nanos) }
    withAgents(mapOf("sensors" to board)) { agents ->
        agents.start("acts", sensing("sim:sensors", BAUD, INTERVAL_MS, actsOnEach(plans)))
        Thread.sleep(WARM_UP_MS)
        ages.isMeasuring = true
        Thread.sleep(MEASURED_MS)
        ages.isMeasuring = false
    }
    acts.heard = { _, _, _ -> }
    return ages.distribution()
}

private fun actsOnEach(plans: Int) =
    (1 until plans).joinToString("") { "+s(I,N) : N == -$it <- benchmarks.acts(0).\n" } + "+s(I,N) <- benchmarks.acts(N).\n"

/** Measures the ages of snapshots. [receivedAt] has the times of the snapshots, by number. */
private class AgeMeter(private val receivedAt: AtomicLongArray) {
    private val ages = LongArray(MAX_ACTIONS)

    @Volatile private var count = 0

    @Volatile var isMeasuring = false

    fun heard(n: Int, nanos: Long) {
        if (isMeasuring && count < MAX_ACTIONS) ages[count++] = nanos - receivedAt.get(n % MAX_ACTIONS)
    }

    fun distribution() = Distribution(ages.copyOf(min(count, MAX_ACTIONS)))
}

/** At this rate, the line takes little of the measured time: about 75 ms for 1,200 percepts. */
private const val BAUD = 2_000_000
private const val INTERVAL_MS = 20
private const val MAX_ACTIONS = 1_000_000
private const val WARM_UP_MS = 3000L
private const val MEASURED_MS = 4000L
