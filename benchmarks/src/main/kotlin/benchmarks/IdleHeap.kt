package benchmarks

import javino.LineSettings
import javino.Protocol
import javino.Transports
import java.lang.ref.Reference

/**
 * Measures the heap of three idle agents in bytes: with Jason only, with `argo.Arch`, and with `argo.Arch` and an open port. The heap of
 * the simulated line and board is not counted.
 */
internal fun idleHeap(): Map<String, Double> {
    val plain = perAgent("!start.\n+!start.\n", null, line = false)
    val arch = perAgent("!start.\n+!start.\n", "argo.Arch", line = false)
    val open = perAgent("!start.\n+!start <- argo.port(\"sim:NAME\").\n", "argo.Arch", line = true) - perLine()
    return mapOf("a Jason agent" to plain, "an ARGO agent" to arch, "an ARGO agent with an open port" to open)
}

private val NAMES = (1..200).map { "idle$it" }
private const val SETTLING_MS = 6000L

private fun boards() = NAMES.associateWith { SensorBoard(Protocol.AUTO, SensorBoard::robot) }

private fun perAgent(program: String, arch: String?, line: Boolean): Double = withAgents(if (line) boards() else emptyMap()) { agents ->
    val before = usedHeap()
    for (name in NAMES) agents.start(name, program.replace("NAME", name), arch)
    Thread.sleep(SETTLING_MS)
    ((usedHeap() - before).toDouble() / NAMES.size).also { Reference.reachabilityFence(agents) }
}

private fun perLine(): Double = withBoards(boards()) {
    val before = usedHeap()
    val lines = NAMES.map { name -> Transports.open("sim:$name", LineSettings.defaults()) }
    Thread.sleep(SETTLING_MS)
    ((usedHeap() - before).toDouble() / NAMES.size).also { lines.forEach { it.close() } }
}

internal fun usedHeap(): Long {
    repeat(3) { System.gc() }
    return Runtime.getRuntime().run { totalMemory() - freeMemory() }
}
