package argo.jason

import argo.Arch
import argo.observing.ObservedAgent
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import jason.asSemantics.Agent
import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax
import jason.infra.local.LocalAgArch
import jason.infra.local.RunLocalMAS
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import kotlinx.coroutines.runBlocking
import java.io.ByteArrayOutputStream
import java.io.ObjectInputStream
import java.io.ObjectOutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.TimeUnit
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.seconds

/** The longest wait of a real-time test for events that take milliseconds on an idle machine. */
internal val LIMIT = 60.seconds

/**
 * Returns when [count] returns [goal] or more. Fails with [clue] if [count] does not grow within [LIMIT]. A busy machine may need long to
 * reach the goal, but [count] still grows within this time.
 */
internal suspend fun awaitGrowth(goal: Int, clue: () -> String, count: () -> Int) {
    var reached = count()
    while (reached < goal) {
        val before = reached
        eventually(LIMIT) {
            reached = count()
            withClue(clue) { reached shouldBeGreaterThan before }
        }
    }
}

/** Jason's Local infrastructure in this process, in real time, for agents given as text. Only one may exist at a time. */
internal open class LocalMas : AutoCloseable {
    private val directory: Path = createTempDirectory("argo-mas")
    private val mas = RunLocalMAS()
    private val records = ConcurrentLinkedQueue<LogRecord>()
    private val handler = object : Handler() {
        override fun publish(record: LogRecord) {
            records += record
        }

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

    val log: String get() = records.joinToString("\n") { "${it.level} ${it.loggerName}: ${it.message}" }

    /** Writes a file with [text] into the project, and returns its path. */
    fun file(name: String, text: String): Path = directory.resolve(name).apply {
        parent.createDirectories()
        writeText(text)
    }

    /** Starts an agent with [program]. [options] are its options in the `.mas2j`, [behind] is a second architecture. */
    open fun agent(name: String, program: String, options: Map<String, String> = emptyMap(), behind: String? = null) {
        agentOf(name, "${file("${name.replace(Regex("\\W"), "_")}.asl", program)}", options, behind)
    }

    /** Starts an agent with the program at [source], a path or a URL. */
    fun agentOf(name: String, source: String, options: Map<String, String> = emptyMap(), behind: String? = null) {
        val settings = Settings().apply { setOptions(HashMap<String, Any>(options)) }
        val services = RuntimeServicesFactory.get()
        services.startAgent(services.createAgent(name, source, null, listOfNotNull("argo.Arch", behind), null, settings, null))
    }

    fun arch(name: String): Arch = generateSequence(mas.getAg(name).firstAgArch) { it.nextAgArch }.filterIsInstance<Arch>().single()

    fun observed(name: String): ObservedAgent = arch(name).observed

    fun achieve(name: String, goal: String) {
        mas.getAg(name).ts.c.addAchvGoal(ASSyntax.parseLiteral(goal), Intention.EmptyInt)
        mas.getAg(name).wake()
    }

    /** Serializes agent [name] between two of its cycles. Reads the bytes back, and runs the read agent under the name [copy]. */
    fun serialize(name: String, copy: String) {
        val written = CompletableFuture<Result<ByteArray>>()
        val ts = mas.getAg(name).ts
        ts.runAtBeginOfNextCycle {
            written.complete(runCatching { ByteArrayOutputStream().also { ObjectOutputStream(it).writeObject(ts.ag) }.toByteArray() })
        }
        mas.getAg(name).wake()
        val bytes = written.get(LIMIT.inWholeSeconds, TimeUnit.SECONDS).getOrThrow()
        val agent = ObjectInputStream(bytes.inputStream()).readObject() as Agent
        val last = generateSequence(agent.ts.agArch) { it.nextAgArch }.last() as LocalAgArch
        last.agName = copy
        last.setLogger()
        agent.setLogger(last)
        agent.ts.setLogger(last)
        mas.addAg(last)
        last.thread = Thread(last).apply { start() }
    }

    fun kill(name: String) {
        RuntimeServicesFactory.get().killAgent(name, "test", 0)
    }

    /** Returns the agent's beliefs, as text without their sources. */
    fun beliefs(name: String): Set<String> =
        mas.getAg(name).ts.ag.bb.asSequence().map { it.copy().apply { clearAnnots() }.toString() }.toSet()

    /** Returns when agent [name] believes [belief]. */
    suspend fun awaitBelief(name: String, belief: String) = eventually(LIMIT) {
        val beliefs = beliefs(name)
        withClue({ "beliefs of $name: $beliefs" }) { (belief in beliefs) shouldBe true }
    }

    override fun close() {
        mas.finish(0, false, 0) // on a separate thread
        runBlocking { eventually(LIMIT) { mas.ags.keys.toSet() shouldBe emptySet() } }
        Logger.getLogger("").removeHandler(handler)
        Files.walk(directory).use { files -> files.sorted(Comparator.reverseOrder()).forEach(Files::delete) }
    }
}
