package argo.recording

import argo.Arch
import argo.observing.ObservedAgent
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.matchers.shouldBe
import jason.infra.local.RunLocalMAS
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import kotlinx.coroutines.runBlocking
import java.nio.file.Path
import java.util.logging.Logger
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.seconds

/** The longest wait of a real-time test. An idle machine needs only milliseconds. */
internal val LIMIT = 60.seconds

/**
 * Runs Jason's Local infrastructure in this process and in real time, with agents that are recorded to [file]. Only one instance at a time.
 */
internal class LiveMas(private val file: Path) : AutoCloseable {
    private val directory = file.parent
    private val mas = RunLocalMAS()
    private val log = Logger.getLogger("")
    private val level = log.level
    private val handlers = log.handlers // Jason removes them
    private val agents = ArrayList<String>()

    init {
        val logging = directory.resolve("logging.properties").apply { writeText("handlers =\n.level = INFO\n") }
        mas.init(arrayOf("--empty-mas", "--no-net", "--log-conf", "$logging"))
        mas.create()
        mas.start()
    }

    fun agent(name: String, program: String, address: (Path) -> String = Path::toString) {
        val source = directory.resolve("$name.asl").apply { writeText(program) }
        val settings = Settings().apply { addOption("argo_record", "$file") }
        val services = RuntimeServicesFactory.get()
        agents += name
        services.startAgent(services.createAgent(name, address(source), null, listOf("argo.Arch"), null, settings, null))
    }

    fun observed(name: String): ObservedAgent = (mas.getAg(name).firstAgArch as Arch).observed

    suspend fun awaitBelief(name: String, belief: String) = eventually(LIMIT) {
        val beliefs = mas.getAg(name).ts.ag.bb.asSequence().map { it.copy().apply { clearAnnots() }.toString() }.toList()
        (if (belief in beliefs) belief else beliefs.toString()) shouldBe belief
    }

    /** Removes the handlers of the agent's logger, as Java does for all loggers at its end. */
    fun loseHandlers(name: String) = mas.getAg(name).ts.logger.run {
        for (handler in handlers) {
            removeHandler(handler)
            handler.close()
        }
    }

    suspend fun awaitDeath(name: String) = eventually(LIMIT) { Thread.getAllStackTraces().keys.count { it.name == name } shouldBe 0 }

    override fun close() {
        mas.finish(0, false, 0) // in a thread of its own
        try {
            runBlocking {
                eventually(LIMIT) { mas.ags.keys.toSet() shouldBe emptySet() }
                agents.forEach { awaitDeath(it) } // an agent that is stopped within a cycle closes its recording after that cycle
            }
        } finally {
            log.level = level
            log.handlers.forEach(log::removeHandler)
            handlers.forEach(log::addHandler)
        }
    }
}
