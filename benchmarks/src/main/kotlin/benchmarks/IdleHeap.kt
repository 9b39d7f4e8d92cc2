package benchmarks

import javino.LineSettings
import javino.Protocol
import javino.Transports
import javino.sim.SimulatedBoards
import java.lang.ref.Reference

/** The heap of an idle agent, in bytes. */
internal class IdleHeap {
    /**
     * Measures an agent of Jason's own, and the parts that `argo.Arch` and an open port add to it; without the simulated line and board.
     */
    fun measure(): Map<String, Double> {
        val plain = perAgent("!start.\n+!start.\n", null, line = false)
        val arch = perAgent("!start.\n+!start.\n", "argo.Arch", line = false)
        val open = perAgent("!start.\n+!start <- argo.port(\"sim:NAME\").\n", "argo.Arch", line = true) - perLine()
        return mapOf("a Jason agent" to plain, "an ARGO agent" to arch, "an ARGO agent with an open port" to open)
    }

    private fun perAgent(program: String, arch: String?, line: Boolean): Double {
        if (line) plugIn()
        try {
            return Agents().use { agents ->
                val before = used()
                for (i in 1..AGENTS) agents.start("idle$i", program.replace("NAME", "idle$i"), arch)
                Thread.sleep(SETTLING_MS)
                ((used() - before) / AGENTS.toDouble()).also { Reference.reachabilityFence(agents) }
            }
        } finally {
            if (line) unplug()
        }
    }

    private fun perLine(): Double {
        plugIn()
        try {
            val before = used()
            val lines = (1..AGENTS).map { Transports.open("sim:idle$it", LineSettings.defaults()) }
            Thread.sleep(SETTLING_MS)
            return ((used() - before) / AGENTS.toDouble()).also { lines.forEach { it.close() } }
        } finally {
            unplug()
        }
    }

    private fun plugIn() = (1..AGENTS).forEach { SimulatedBoards.plugIn("idle$it", SensorBoard(Protocol.AUTO, SensorBoard::robot)) }

    private fun unplug() = (1..AGENTS).forEach { SimulatedBoards.unplug("idle$it") }

    private fun used(): Long = usedHeap()

    private companion object {
        const val AGENTS = 200
        const val SETTLING_MS = 6000L
    }
}

/** Collects garbage and returns the heap in use, in bytes. */
internal fun usedHeap(): Long {
    repeat(3) { System.gc() }
    return Runtime.getRuntime().run { totalMemory() - freeMemory() }
}
