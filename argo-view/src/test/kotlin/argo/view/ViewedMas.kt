package argo.view

import argo.Arch
import argo.observing.ObservedAgent
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax
import jason.infra.local.RunLocalMAS
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import kotlinx.coroutines.runBlocking
import java.net.URI
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.seconds

/** The longest wait of a test. Even a slow machine needs less time. */
internal val LIMIT = 60.seconds

/** A real Jason in this process, for agents with live views. Only one may exist at a time. */
internal class ViewedMas : AutoCloseable {
    private val directory: Path = createTempDirectory("argo-view")
    private val mas = RunLocalMAS()
    private val records = ConcurrentLinkedQueue<LogRecord>()
    private val handler = object : Handler() {
        override fun publish(record: LogRecord) { records += record }
        override fun flush() = Unit
        override fun close() = Unit
    }

    init {
        val logging = directory.resolve("logging.properties").apply { writeText("handlers =\n.level = INFO\n") }
        mas.init(arrayOf("--empty-mas", "--no-net", "--log-conf", logging.toString()))
        Logger.getLogger("").addHandler(handler)
        mas.create()
        mas.start()
    }

    val log: String get() = records.joinToString("\n") { it.message.orEmpty() }

    /** Starts an agent with [program]. [view] is its option `argo_view`, and [options] are its other options. */
    fun agent(name: String, program: String, view: String = "0", options: Map<String, String> = emptyMap()) {
        val source = directory.resolve("${name.replace(Regex("\\W"), "_")}.asl").apply { writeText(program) }
        val settings = Settings().apply { setOptions(HashMap<String, Any>(options + ("argo_view" to view))) }
        val services = RuntimeServicesFactory.get()
        services.startAgent(services.createAgent(name, source.toString(), null, listOf("argo.Arch"), null, settings, null))
    }

    /** Writes a file of the project, next to the files of its agents. */
    fun file(name: String, text: String) {
        directory.resolve(name).apply { parent.createDirectories() }.writeText(text)
    }

    fun achieve(name: String, goal: String) {
        mas.getAg(name).ts.c.addAchvGoal(ASSyntax.parseLiteral(goal), Intention.EmptyInt)
        mas.getAg(name).wake()
    }

    fun kill(name: String) {
        RuntimeServicesFactory.get().killAgent(name, "test", 0)
    }

    fun beliefs(name: String): Set<String> =
        mas.getAg(name).ts.ag.bb.asSequence().map { it.copy().apply { clearAnnots() }.toString() }.toSet()

    suspend fun awaitBelief(name: String, belief: String) = eventually(LIMIT) { beliefs(name) shouldContain belief }

    fun agentView(name: String): AgentView = arch(name).observers.filterIsInstance<AgentView>().single()

    fun observed(name: String): ObservedAgent = arch(name).observed

    private fun arch(name: String) = generateSequence(mas.getAg(name).firstAgArch) { it.nextAgArch }.filterIsInstance<Arch>().single()

    fun viewOf(name: String): URI {
        val line = Regex("the live view of $name is at (http://127\\.0\\.0\\.1:\\d+/\\S+/)").find(log)
        return URI(checkNotNull(line) { log }.groupValues[1])
    }

    override fun close() {
        mas.finish(0, false, 0) // on a separate thread
        runBlocking { eventually(LIMIT) { mas.ags.keys.toSet() shouldBe emptySet() } }
        Logger.getLogger("").removeHandler(handler)
        Files.walk(directory).use { files -> files.sorted(Comparator.reverseOrder()).forEach(Files::delete) }
    }
}
