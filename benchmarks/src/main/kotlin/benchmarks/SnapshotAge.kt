package benchmarks

import javino.Protocol
import javino.sim.SimulatedBoards
import java.util.concurrent.atomic.AtomicLongArray
import kotlin.math.min

/**
 * The age of an agent's newest snapshot when one of its intentions acts on it: from the last byte of the board's answer to the first action
 * of a plan for one of its percepts. All [sensors] change in each answer, each change is an event, and for each event the agent has [plans]
 * plans of which the last applies.
 */
internal class SnapshotAge(private val sensors: Int, private val plans: Int) {
    private val receivedAt = AtomicLongArray(MAX_ACTIONS)
    private val ages = LongArray(MAX_ACTIONS)

    @Volatile private var count = 0

    @Volatile private var measuring = false

    fun measure(): Distribution {
        val witness = object : SensorBoard.Witness {
            override fun answered(n: Int, endNanos: Long, bytes: Int) = receivedAt.set(n % MAX_ACTIONS, endNanos)
        }
        val board = SensorBoard(Protocol.AUTO, { n -> (1..sensors).joinToString("") { "s($it,$n);" } }, witness)
        acts.heard = ::heard
        SimulatedBoards.plugIn("sensors", board)
        try {
            Agents().use { agents ->
                agents.start("acts", program())
                Thread.sleep(WARM_UP_MS)
                measuring = true
                Thread.sleep(MEASURED_MS)
                measuring = false
            }
        } finally {
            SimulatedBoards.unplug("sensors")
            acts.heard = { _, _ -> }
        }
        return Distribution(ages.copyOf(min(count, MAX_ACTIONS)))
    }

    private fun program() =
        "!start.\n+!start <- argo.port(\"sim:sensors\", [baud($BAUD)]); argo.limit($INTERVAL_MS); argo.percepts(open).\n" +
            (1 until plans).joinToString("") { "+s(I,N) : N == -$it <- benchmarks.acts(0).\n" } + "+s(I,N) <- benchmarks.acts(N).\n"

    private fun heard(n: Int, nanos: Long) {
        if (measuring && count < MAX_ACTIONS) ages[count++] = nanos - receivedAt.get(n % MAX_ACTIONS)
    }

    companion object {
        /** At this rate the line does not hide the agent's own time: 1,200 percepts take some 75 ms. */
        const val BAUD = 2_000_000
        const val INTERVAL_MS = 20
        private const val MAX_ACTIONS = 1_000_000
        private const val WARM_UP_MS = 3000L
        private const val MEASURED_MS = 4000L
    }
}
