package benchmarks

import javino.Protocol
import java.util.BitSet

/**
 * Tests many agents, each with a board in memory. The agents sense at 50 Hz and act on each answer. Heap and threads must not grow. Each
 * action must be carried out exactly once.
 *
 * @param seconds the length of the run, at least 3. Heap and threads may grow until all agents act, and for one more minute. In a short
 * run, they may grow for a third of it
 */
class Soak(private val agents: Int, private val seconds: Int) {
    /** The figures of a run. The heap is in bytes after a garbage collection. */
    class Result(
        val heapEarly: Long, val heapLate: Long, val threadsEarly: Int, val threadsLate: Int,
        val answers: Long, val confirmed: Long, val failed: Long, val carriedOut: Long, val twice: Long, val lost: Long,
    ) {
        /** The faults of the run in words, or an empty list. */
        val faults: List<String> get() = listOfNotNull(
            "no action was confirmed".takeIf { confirmed == 0L },
            "$twice actions were carried out twice".takeIf { twice > 0 },
            "$lost actions were lost".takeIf { lost > 0 },
            "more actions were carried out than issued".takeIf { carriedOut > confirmed + failed },
            "$threadsLate threads in place of $threadsEarly".takeIf { threadsLate > threadsEarly + SPARE_THREADS },
            "the heap has grown from ${heapEarly / MB} to ${heapLate / MB} MB"
                .takeIf { heapLate >= heapEarly + heapEarly / 4 + SPARE_HEAP },
        )

        override fun toString() = "heap ${heapEarly / MB} MB, then ${heapLate / MB} MB; threads $threadsEarly, then $threadsLate; " +
            "$answers answers; $confirmed actions confirmed, $failed failed, $carriedOut carried out, $twice twice, $lost lost"
    }

    private val boards = (1..agents).map { Account() }

    fun run(): Result {
        acts.heard = { n, _, (_, agent, what) -> boards["$agent".toInt() - 1].told(n, "$what") }
        val plugged = boards.mapIndexed { i, account ->
            "soak${i + 1}" to
                SensorBoard(Protocol.AUTO, { "tick($it);" + SensorBoard.robot(it) }, { _, _, _ -> account.answered() }, account::acted)
        }
        return withAgents(plugged.toMap()) { mas ->
            for (i in 1..agents) mas.start("soak$i", program(i))
            Thread.sleep(minOf(60, seconds / 3) * 1000L)
            awaitAtMost(LIMIT_S) { boards.all { it.confirmed >= WARM_UP_ACTIONS } }
            val heap = steadyHeap()
            val threads = Thread.activeCount()
            Thread.sleep((seconds - minOf(60, seconds / 3)) * 1000L)
            val heapLate = steadyHeap()
            val threadsLate = Thread.activeCount()
            for (i in 1..agents) mas.achieve("soak$i", "end")
            awaitAtMost(LIMIT_S) { boards.all { it.isSettled() } }
            Result(
                heap, heapLate, threads, threadsLate,
                boards.sumOf { it.answers }, boards.sumOf { it.confirmed }, boards.sumOf { it.failed },
                boards.sumOf { it.carriedOut }, boards.sumOf { it.twice }, boards.sumOf { it.lost() },
            )
        }
    }

    /** Returns the least heap of some samples. Acting agents briefly use some 10 MB more. */
    private fun steadyHeap() = (1..HEAP_SAMPLES).minOf {
        Thread.sleep(HEAP_SAMPLE_MS)
        usedHeap()
    }

    private fun program(i: Int) = sensing("sim:soak$i", BAUD, intervalMs = 20) + """
        +tick(N) <- !act(N).
        +!act(N) <- benchmarks.acts(N, $i, begun); argo.act(did(N)); benchmarks.acts(N, $i, done).
        -!act(N) <- benchmarks.acts(N, $i, failed).
        +!end    <- argo.percepts(block).
    """

    /** Compares the actions that one agent ordered with those that its board carried out. Safe for use by several threads. */
    private class Account {
        private val ordered = BitSet()
        private val acted = BitSet()
        private val known = BitSet()
        private val done = BitSet()
        var answers = 0L
            @Synchronized get
            private set
        var twice = 0L
            @Synchronized get
            private set
        var failed = 0L
            @Synchronized get
            private set
        val carriedOut: Long @Synchronized get() = acted.cardinality().toLong()
        val confirmed: Long @Synchronized get() = done.cardinality().toLong()

        @Synchronized
        fun answered() {
            answers++
        }

        @Synchronized
        fun acted(action: String) {
            val n = action.substringAfter("did(").substringBefore(')').toInt()
            if (acted[n]) twice++
            acted.set(n)
        }

        @Synchronized
        fun told(n: Int, what: String) {
            if (what == "begun") ordered.set(n) else known.set(n)
            if (what == "done") done.set(n)
            if (what == "failed") failed++
        }

        @Synchronized
        fun isSettled() = ordered == known

        /** Returns the number of actions that were confirmed but not carried out, or whose outcome is unknown. */
        @Synchronized
        fun lost(): Long {
            val unknown = (ordered.clone() as BitSet).apply { andNot(known) }
            val undone = (done.clone() as BitSet).apply { andNot(acted) }
            return unknown.cardinality() + undone.cardinality().toLong()
        }
    }

    private companion object {
        const val BAUD = 2_000_000
        const val LIMIT_S = 60

        /** After this number of actions, an agent has loaded all classes and allocated all buffers. */
        const val WARM_UP_ACTIONS = 50L
        const val MB = 1024 * 1024L
        const val SPARE_HEAP = 8 * MB

        const val HEAP_SAMPLES = 8
        const val HEAP_SAMPLE_MS = 100L

        /** The allowed growth, since other threads of the program start and end. */
        const val SPARE_THREADS = 2
    }
}

internal fun soak(): Boolean {
    val result = Soak(agents = 100, seconds = 600).run()
    println("100 agents at 50 Hz for 600 s: $result")
    result.faults.forEach(System.err::println)
    return result.faults.isEmpty()
}
