package benchmarks

import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax
import jason.infra.local.RunLocalMAS
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import javino.sim.SimulatedBoard
import javino.sim.SimulatedBoards
import java.nio.file.Path
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText

/** Runs Jason in this process, with agents whose programs are given as text. Only one Jason can run at a time. */
class Agents : AutoCloseable {
    private val directory: Path = createTempDirectory("argo-bench")
    private val mas = RunLocalMAS()

    init {
        val logging = directory.resolve("logging.properties").apply {
            writeText("handlers = java.util.logging.ConsoleHandler\n.level = WARNING\n")
        }
        mas.init(arrayOf("--empty-mas", "--no-net", "--log-conf", logging.toString()))
        mas.create()
        mas.start()
    }

    /**
     * Starts the agent [name] with [program], and with [options] like those of a `.mas2j`. [arch] is its architecture, or null for Jason's
     * own.
     */
    fun start(name: String, program: String, arch: String? = "argo.Arch", options: Map<String, String> = emptyMap()) {
        val source = directory.resolve("$name.asl").apply { writeText(program) }
        val services = RuntimeServicesFactory.get()
        val settings = Settings().apply { options.forEach(::addOption) }
        services.startAgent(services.createAgent(name, source.toString(), null, listOfNotNull(arch), null, settings, null))
    }

    fun achieve(name: String, goal: String) {
        mas.getAg(name).ts.c.addAchvGoal(ASSyntax.parseLiteral(goal), Intention.EmptyInt)
        mas.getAg(name).wake()
    }

    override fun close() {
        mas.finish(0, false, 0) // returns at once; another thread of Jason ends the agents
        if (!awaitAtMost(LIMIT_S) { mas.ags.isEmpty() }) System.err.println("agents still run after $LIMIT_S s: ${mas.ags.keys}")
        directory.toFile().deleteRecursively()
    }

    private companion object {
        const val LIMIT_S = 60
    }
}

/** Runs [measure] with a new Jason and the simulated [boards], whose ports are `sim:` and the name. */
internal fun <T> withAgents(boards: Map<String, SimulatedBoard>, measure: (Agents) -> T): T = withBoards(boards) { Agents().use(measure) }

internal fun <T> withBoards(boards: Map<String, SimulatedBoard>, measure: () -> T): T {
    boards.forEach(SimulatedBoards::plugIn)
    try {
        return measure()
    } finally {
        boards.keys.forEach(SimulatedBoards::unplug)
    }
}

/**
 * Returns the program of an agent that senses the board at [port] every [intervalMs]. [plans] are its other plans. [options] are more
 * options of the port, each behind a comma.
 */
internal fun sensing(port: String, baud: Int, intervalMs: Int, plans: String = "", options: String = "") =
    "!start.\n+!start <- argo.port(\"$port\", [baud($baud)$options]); argo.limit($intervalMs); argo.percepts(open).\n$plans"

internal fun awaitAtMost(seconds: Int, condition: () -> Boolean): Boolean {
    val end = System.nanoTime() + seconds * 1_000_000_000L
    while (!condition()) {
        if (System.nanoTime() > end) return false
        Thread.sleep(LOOK_MS)
    }
    return true
}

private const val LOOK_MS = 20L
