package argo.fleet

import argo.Arch
import argo.fleet.agents.FleetAgArch
import argo.fleet.node.Fleet
import argo.observing.ObservedComputer
import argo.platform.Plans
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.ints.shouldBeGreaterThanOrEqual
import jason.mas2j.ClassParameters
import jason.mas2j.parser.mas2j
import jason.util.Config
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.seconds

/**
 * The computer `base` of a fleet. A test plays the other computers.
 *
 * @param placed the agents of the project file, such as `a at "base";`
 * @param programs the programs of agents, by agent name
 */
internal class OneComputer(placed: String, vararg programs: Pair<String, String>) : AutoCloseable {
    private val directory = createTempDirectory("fleet")
    val cluster = FakeCluster("base")
    private val mas: FleetMas
    private val records = ConcurrentLinkedQueue<LogRecord>()
    private val handler = object : Handler() {
        override fun publish(record: LogRecord) {
            records += record
        }

        override fun flush() = Unit
        override fun close() = Unit
    }
    val fleet: Fleet

    init {
        Logger.getLogger("").addHandler(handler)
        Config.get()[Config.START_WEB_MI] = "false" // starts no web server
        programs.forEach { (agent, program) -> directory.resolve("$agent.asl").writeText(program) }
        val project = mas2j(
            """
            MAS test {
                infrastructure: Fleet(hosts([base("127.0.0.1:1"),scout1("127.0.0.1:2"),scout2("127.0.0.1:3")]))
                agents: $placed
                aslSourcePath: "$directory";
            }
            """.byteInputStream(),
        ).mas()
        project.setupDefault()
        project.fixAgentsSrc()
        val described = FleetProject(project)
        project.infrastructure = ClassParameters("Local")
        mas = FleetMas().apply { this.project = project }
        fleet = Fleet(cluster, described.planned, described.hosts, Logger.getLogger("test"), described.views)
        mas.run(fleet, described.agents, described.hosts.size)
    }

    fun believed(agent: String): List<String> = mas.getAg(agent)?.ts?.ag?.bb?.map { "$it" }.orEmpty()

    fun planLabels(agent: String): List<String> = Plans.of(mas.getAg(agent).ts.ag).all.map { it.label.functor }

    fun longestSleepMs(agent: String): Long = (mas.getAg(agent) as FleetAgArch).longestSleepMs

    fun observed(agent: String): List<ObservedComputer> = (mas.getAg(agent).firstAgArch as Arch).observed.computers

    /** Waits until [agent] has all [beliefs]. */
    suspend fun shouldBelieve(agent: String, vararg beliefs: String) =
        eventually(60.seconds) { believed(agent) shouldContainAll beliefs.asList() }

    /** Waits until at least [times] lines of the log contain [text]. */
    suspend fun shouldLog(text: String, times: Int = 1) =
        eventually(60.seconds) { records.count { text in it.message } shouldBeGreaterThanOrEqual times }

    /** What was thrown with each line of the log that has [text]; null: nothing. */
    fun thrown(text: String): List<Throwable?> = records.filter { text in it.message }.map { it.thrown }

    /** The lines of the log with [text]. */
    fun logged(text: String): List<String> = records.map { it.message }.filter { text in it }

    val isRunning: Boolean get() = mas.isRunning

    override fun close() {
        mas.finish(0, false, 0)
        Logger.getLogger("").removeHandler(handler)
        directory.toFile().deleteRecursively()
    }
}
