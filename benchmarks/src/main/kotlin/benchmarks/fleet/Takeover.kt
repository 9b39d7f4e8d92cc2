package benchmarks.fleet

import benchmarks.figures

private const val TIMES = 5
private const val MAX_MS = 5000L
private const val PATIENCE_S = 60

/**
 * Measures the takeover of an agent that counts ten times per second and survives its computer. After the computer's process is killed,
 * measures the time without counting and the lost part of the count.
 */
internal fun takeovers(): Boolean {
    val names = listOf("one", "two", "three")
    val mas2j = "MAS bench { infrastructure: ${Project.fleetOf(names)} agents: counter at \"${names.joinToString()}\"; }"
    return Project(mas2j, listOf("counter")).use { project ->
        val processes = names.map(project::startComputer)
        val computers = processes.associateBy { it.pid() }.toMutableMap()
        val named = processes.map { it.pid() }.zip(names).toMap().toMutableMap()
        fun counts() = project.noted(COUNTS).map { (pid, nanos, count) -> Triple(pid, nanos, count) }
        val gaps = List(TIMES) {
            val before = counts().size
            project.await(PATIENCE_S, "a count") { counts().size > before + 100 }
            val (owner, _, last) = counts().last()
            val killed = System.nanoTime()
            computers.remove(owner)!!.destroyForcibly().waitFor()
            project.await(PATIENCE_S, "a count of another computer") { counts().last().first != owner }
            val next = counts().first { (pid, nanos) -> nanos > killed && pid != owner }
            val again = project.startComputer(named.getValue(owner))
            computers[again.pid()] = again
            named[again.pid()] = named.getValue(owner)
            (next.second - killed) / 1_000_000 to last - next.third
        }
        val (times, lost) = gaps.unzip()
        println(
            figures("an agent goes on %,d ms after its computer was killed, %,d at most", times.sorted()[TIMES / 2], times.max()) +
                figures(", and has lost %.1f s of what it believed, %.1f at most", lost.sorted()[TIMES / 2] / 10.0, lost.max() / 10.0),
        )
        times.max() <= MAX_MS && lost.max() * 100 <= MAX_MS
    }
}
