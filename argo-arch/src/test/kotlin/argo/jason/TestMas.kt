package argo.jason

import argo.Arch
import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax
import jason.environment.Environment
import jason.infra.local.RunLocalMAS
import jason.mas2j.ClassParameters
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText

/**
 * A real Jason, on its Local infrastructure, in this process, for agents given as text. One at a time.
 */
class TestMas : AutoCloseable {
    private val directory: Path = createTempDirectory("argo-mas")
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
        mas.project.envClass = ClassParameters(TestEnvironment::class.java.name)
        Logger.getLogger("").addHandler(handler)
        mas.create()
        mas.start()
    }

    /** What has been logged so far, one message a line. */
    val log: String get() = records.joinToString("\n") { "${it.level} ${it.loggerName}: ${it.message}" }

    /** Starts an agent with [program]; [options] are those in brackets in a `.mas2j`, [behind] is a second architecture. */
    fun agent(name: String, program: String, arch: String? = "argo.Arch", options: Map<String, String> = emptyMap(), behind: String? = null) {
        val source = directory.resolve("$name.asl").apply { writeText(program) }
        val settings = Settings().apply { setOptions(HashMap<String, Any>(options)) }
        val services = RuntimeServicesFactory.get()
        val created = services.createAgent(name, source.toString(), null, listOfNotNull(arch, behind), null, settings, null)
        services.startAgent(created)
    }

    /** Writes a file of the project, beside its agents. */
    fun file(name: String, text: String) {
        directory.resolve(name).apply { parent.createDirectories() }.writeText(text)
    }

    /** Makes [percepts] all that the Jason environment shows. */
    fun perceive(vararg percepts: String) {
        val environment = mas.environmentInfraTier.userEnvironment
        environment.clearPercepts()
        environment.addPercept(*percepts.map(ASSyntax::parseLiteral).toTypedArray())
        environment.informAgsEnvironmentChanged()
    }

    /** Gives agent [name] the goal. */
    fun achieve(name: String, goal: String) {
        mas.getAg(name).ts.c.addAchvGoal(ASSyntax.parseLiteral(goal), Intention.EmptyInt)
        mas.getAg(name).wake()
    }

    /** Stops agent [name] as `.kill_agent` does. */
    fun kill(name: String) {
        RuntimeServicesFactory.get().killAgent(name, "test", 0)
    }

    /** The agent's architecture. */
    fun architecture(name: String): Arch = generateSequence(mas.getAg(name).firstAgArch) { it.nextAgArch }.filterIsInstance<Arch>().single()

    /** The agent's beliefs, as text without their sources. */
    fun beliefs(name: String): Set<String> =
        mas.getAg(name).ts.ag.bb.asSequence().map { it.copy().apply { clearAnnots() }.toString() }.toSet()

    override fun close() {
        mas.finish(0, false, 0) // on a thread of its own
        eventually({ mas.ags.keys }) { mas.ags.isEmpty() }
        Logger.getLogger("").removeHandler(handler)
        Files.walk(directory).use { files -> files.sorted(Comparator.reverseOrder()).forEach(Files::delete) }
    }
}

/** A Jason environment that shows what a test gives it. */
class TestEnvironment : Environment()
