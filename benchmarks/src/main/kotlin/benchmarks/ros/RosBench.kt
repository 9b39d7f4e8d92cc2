package benchmarks.ros

import benchmarks.Agents
import benchmarks.Distribution
import benchmarks.acts
import benchmarks.awaitAtMost
import benchmarks.figures
import benchmarks.machine
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.TimeUnit

private const val RESTARTS = 10
private const val PATIENCE_S = 20
private const val OFF_MS = 300L
private const val WORK_MS = 100L

/**
 * Measures the time from a scan to its command, compared with a roslibpy client. At each of [rates], measures the age of the messages on
 * which an agent acts. The agent takes 100 ms for each action. Also measures the time until an agent acts again after a restart of its
 * bridge. Prints the figures.
 *
 * @param seconds the measuring time for each rate
 * @param python a Python with roslibpy, or null to skip the comparison
 * @return true if the agent is at least as fast as the client, acts after each restart, carries out no command twice, and leaves no thread
 * or connection behind
 */
fun ros(python: String?, seconds: Int = 60, rates: List<Int> = listOf(50, 200, 1_000)): Boolean {
    println("robots behind ros://, ${machine()}:")
    val isAsFast = python == null || reactions(python)
    println("age of the messages that an agent acts on, at $WORK_MS ms a message, $seconds s each:")
    rates.forEach { hz -> println("$hz Hz: ${ages(hz, seconds)}") }
    return Restarts().run() && isAsFast
}

private fun program(number: Int) = """
    !start.
    +!start <- argo.port("ros://127.0.0.1:$number#rosbench"); argo.percepts(open).
    +n(K) <- benchmarks.acts(K); argo.act(did(K)).
"""

private fun ages(hz: Int, seconds: Int): String {
    val published = ConcurrentHashMap<Int, Long>()
    val ages = ConcurrentLinkedQueue<Pair<Long, Long>>() // pairs of a time and the age of a message at that time
    acts.heard = { number, now, _ ->
        ages += now to now - published.getValue(number)
        try {
            Thread.sleep(WORK_MS)
        } catch (_: InterruptedException) {
            Thread.currentThread().interrupt() // the agent is stopped
        }
    }
    var lateNanos = 0L
    CountingBridge(0, 0, hz) { published[it] = System.nanoTime() }.use { bridge ->
        Agents().use {
            it.start("bob", program(bridge.number))
            lateNanos = longestDelay(seconds)
        }
    }
    val all = Distribution(ages.map { (_, age) -> age }.toLongArray())
    val end = ages.lastOrNull()?.first ?: return "nothing came"
    val last = Distribution(ages.filter { (now, _) -> end - now < TimeUnit.SECONDS.toNanos(1) }.map { (_, age) -> age }.toLongArray())
    return figures(
        "median %.0f, 99th percentile %.0f, longest %.0f ms of %d; in the last second at most %.0f ms; a thread that sleeps woke %.0f ms " +
            "late at most",
        all.ms(0.5), all.ms(0.99), all.ms(1.0), all.size, last.ms(1.0), lateNanos / 1e6,
    )
}

/** Sleeps for [seconds] in steps of one ms. Returns the greatest delay of a step in ns. */
private fun longestDelay(seconds: Int): Long {
    val end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds.toLong())
    val times = generateSequence(System.nanoTime()) { System.nanoTime().also { Thread.sleep(1) } }.takeWhile { it < end }
    return times.zipWithNext { one, next -> next - one }.max() - TimeUnit.MILLISECONDS.toNanos(1)
}

private class Restarts {
    private val done = ArrayList<Int>()
    private var next = 0

    fun run(): Boolean {
        val times = ArrayList<Long>()
        var threads = 0
        acts.heard = { _, _, _ -> }
        var bridge = CountingBridge(0, 0, RATE) { next = it + 1 }
        var isGood = true
        Agents().use { agents ->
            agents.start("bob", program(bridge.number))
            isGood = awaitAtMost(PATIENCE_S) { bridge.done.isNotEmpty() }
            threads = threads()
            repeat(RESTARTS) {
                bridge.close()
                done += bridge.done
                Thread.sleep(OFF_MS)
                val begun = System.nanoTime()
                bridge = CountingBridge(bridge.number, next, RATE) { next = it + 1 }
                isGood = awaitAtMost(PATIENCE_S) { bridge.done.isNotEmpty() } && bridge.clients == 1 && isGood
                times += System.nanoTime() - begun
                isGood = awaitAtMost(PATIENCE_S) { bridge.done.size >= COMMANDS } && isGood
            }
            isGood = awaitAtMost(PATIENCE_S) { threads() <= threads } && isGood
        }
        done += bridge.done
        isGood = awaitAtMost(PATIENCE_S) { bridge.clients == 0 } && isGood
        bridge.close()
        val twice = done.size - done.distinct().size
        val again = Distribution(times.toLongArray())
        println(figures("bridge restarted $RESTARTS times: acts again after %.0f ms, %.0f at most", again.ms(0.5), again.ms(1.0)))
        println("commands: ${done.size}, of these twice: $twice; threads of ports at most as before, and one connection: $isGood")
        return isGood && twice == 0
    }

    private fun threads() = Thread.getAllStackTraces().keys.count { it.name.startsWith("argo-bob") }

    private companion object {
        const val RATE = 50

        /** The smallest number of commands between two restarts. */
        const val COMMANDS = 20
    }
}
