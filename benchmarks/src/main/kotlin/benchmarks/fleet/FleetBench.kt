package benchmarks.fleet

import argo.fleet.trial.Kind
import argo.fleet.trial.Namespaces
import argo.fleet.trial.Trial
import benchmarks.figures
import benchmarks.machine
import kotlin.random.Random

private const val FEW = 5
private const val MANY = 10
private const val FAILURES = 10
private const val MESSAGES = 1_000_000
private const val MAX_KILLED_MS = 1000
private const val MAX_UNPLUGGED_MS = 3000
private val CROWDS = listOf(2, 10, 50)

/** The measurements, by name. Each prints its figures and returns true if they reach the goal. */
private val ROWS: Map<String, () -> Boolean> = mapOf(
    "send" to ::pingPongs,
    "failures" to ::noticed,
    "takeover" to ::takeovers,
    "messages" to ::manyMessages,
    "crowd" to ::crowd,
    "membership" to ::membership,
)

/**
 * Measures a fleet of several computers. Each computer is a process on this machine, if possible in its own network namespace. Measures the
 * round trip of a message, compared with JADE, and the time until a failure is detected. Also measures the outcomes of a million messages
 * while computers fail, and the cost of membership.
 *
 * @param rows the names of the measurements, or an empty list for all
 * @return true if all goals are reached
 */
internal fun fleet(rows: List<String>): Boolean {
    val unknown = rows - ROWS.keys
    if (unknown.isNotEmpty()) {
        System.err.println("there is no row ${unknown.joinToString()}; there are ${ROWS.keys.joinToString()}")
        return false
    }
    println(machine())
    return ROWS.filterKeys { rows.isEmpty() || it in rows }.map { (_, row) -> row() }.all { it }
}

private fun names(count: Int) = List(count) { "computer${it + 1}" }

/** Runs [trial] with [count] computers in network namespaces. If namespaces cannot be made, prints that and returns true. */
private fun inNamespaces(what: String, count: Int, trial: (Trial, Namespaces, List<String>) -> Boolean): Boolean {
    Namespaces.missing?.let {
        println("$what: left out, since $it")
        return true
    }
    val names = names(count)
    return Namespaces(names).use { network ->
        Trial(names, network).use { running ->
            names.forEach {
                running.start(it)
                if (count > MANY) Thread.sleep(PACE_MS)
            }
            running.awaitAll()
            trial(running, network, names)
        }
    }
}

private fun noticed() = inNamespaces("failures", FEW) { trial, network, names ->
    val killed = List(FAILURES) { names[it % FEW] }.map { name ->
        val since = System.nanoTime()
        trial.kill(name)
        trial.noticed(name, since).last.also {
            trial.start(name)
            trial.awaitAll()
        }
    }
    val unplugged = List(FAILURES) { names[it % FEW] }.map { name ->
        val since = System.nanoTime()
        network.unplug(name)
        trial.noticed(name, since).last.also {
            network.plug(name)
            trial.awaitAll()
        }
    }
    for ((what, times) in listOf("process killed" to killed, "computer unplugged" to unplugged)) {
        println(figures("%s, noticed by the last of %d others: median %d ms, longest %d ms", what, FEW - 1, times.median(), times.max()))
    }
    killed.max() <= MAX_KILLED_MS && unplugged.max() <= MAX_UNPLUGGED_MS
}

private fun List<Long>.median() = sorted()[size / 2]

private fun manyMessages() = inNamespaces("messages", MANY) { trial, network, names ->
    val random = Random(1)
    val begin = System.nanoTime()
    trial.send()
    var events = 0
    while (trial.sent() < MESSAGES) {
        trial.disturb(network, names.random(random), random)
        events++
    }
    names.filter { it !in trial.running }.forEach(trial::start)
    trial.awaitAll()
    trial.finish()
    val history = trial.history()
    val faults = history.faults()
    println(
        figures(
            "%,d messages among %d computers, %d times one killed or unplugged, in %d s: %,d taken, %,d reported failed, %d faults",
            history.count(Kind.SENT), MANY, events, (System.nanoTime() - begin) / 1_000_000_000, history.count(Kind.TAKEN),
            history.count(Kind.FAILED), faults.size,
        ),
    )
    faults.take(20).forEach(::println)
    faults.isEmpty()
}

/** Disturbs the computer [name]: kills it, starts it again, or unplugs it for some seconds. */
private fun Trial.disturb(network: Namespaces, name: String, random: Random) {
    Thread.sleep(random.nextLong(2000))
    when {
        name !in running -> start(name)
        random.nextBoolean() -> kill(name)
        else -> {
            network.unplug(name)
            Thread.sleep(random.nextLong(6000))
            network.plug(name)
        }
    }
}

private fun membership() = CROWDS.map { count ->
    inNamespaces("membership", count) { _, network, names ->
        val seconds = 20
        Thread.sleep(seconds * 1000L) // until all computers have joined
        val before = names.sumOf(network::bytesSent)
        Thread.sleep(seconds * 1000L)
        val rate = (names.sumOf(network::bytesSent) - before) / seconds / count
        println(figures("membership of %d computers: each sends %,d bytes a second, %,d to each other", count, rate, rate / (count - 1)))
        true
    }
}.all { it }
