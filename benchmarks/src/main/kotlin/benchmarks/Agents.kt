package benchmarks

import jason.infra.local.RunLocalMAS
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import java.nio.file.Path
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText

/** A Jason in this process, whose agents are given as text. One at a time. */
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

    /** Starts agent [name] with [program] and [options] of its `.mas2j` on [arch]; null: Jason's own architecture. */
    fun start(name: String, program: String, arch: String? = "argo.Arch", options: Map<String, String> = emptyMap()) {
        val source = directory.resolve("$name.asl").apply { writeText(program) }
        val services = RuntimeServicesFactory.get()
        val settings = Settings().apply { options.forEach(::addOption) }
        services.startAgent(services.createAgent(name, source.toString(), null, listOfNotNull(arch), null, settings, null))
    }

    /** Gives agent [name] the goal. */
    fun achieve(name: String, goal: String) {
        mas.getAg(name).ts.c.addAchvGoal(jason.asSyntax.ASSyntax.parseLiteral(goal), jason.asSemantics.Intention.EmptyInt)
        mas.getAg(name).wake()
    }

    /** Ends the system; returns when its agents have ended. */
    override fun close() {
        mas.finish(0, false, 0) // on a thread of its own
        awaitAtMost(LIMIT_S) { mas.ags.isEmpty() }
        directory.toFile().deleteRecursively()
    }

    private companion object {
        const val LIMIT_S = 60
    }
}

/** Waits until [condition] holds, at most [seconds] s; returns true if it does. */
internal fun awaitAtMost(seconds: Int, condition: () -> Boolean): Boolean {
    val end = System.nanoTime() + seconds * 1_000_000_000L
    while (!condition()) {
        if (System.nanoTime() > end) return false
        Thread.sleep(LOOK_MS)
    }
    return true
}

private const val LOOK_MS = 20L
