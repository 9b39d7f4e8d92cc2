package argo.fleet.node

import argo.fleet.Nobody
import argo.fleet.cluster.Cluster
import argo.fleet.cluster.ClusterListener
import argo.fleet.cluster.InMemoryNetwork
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import java.util.logging.Level
import java.util.logging.Logger
import kotlin.random.Random

/** Loses messages that have arrived, as an error in the receiving computer would, as long as [isLosing]. */
private class Forgetful(private val cluster: Cluster, private val isLosing: () -> Boolean) : Cluster by cluster {
    override fun listen(listener: ClusterListener) = cluster.listen(object : ClusterListener by listener {
        override fun message(from: String, message: ByteArray) {
            if (!isLosing()) listener.message(from, message)
        }
    })
}

/** Computers of a fleet in memory, in virtual time; what they do and what happens to them depends on [random] only. */
private class Computers(private val names: List<String>, private val random: Random) : AutoCloseable {
    private val network = InMemoryNetwork(names.toSet())
    private val running = HashMap<String, Pair<Fleet, Takeover>>()
    private var isQuiet = false
    private var agents = 0

    init {
        names.forEach(::start)
    }

    private fun start(name: String) {
        val cluster = Forgetful(network.join(name)) { !isQuiet && random.nextInt(4) == 0 }
        val fleet = Fleet(cluster, emptyMap(), emptyMap(), LOG)
        val takeover = Takeover(fleet, emptyMap(), names.size, NoAgents, LOG)
        fleet.came("of_$name")
        fleet.join(Nobody, takeover)
        running[name] = fleet to takeover
    }

    fun disturb() {
        val name = names.random(random)
        val fleet = running.getValue(name).first
        when (random.nextInt(8)) {
            0 -> network.part(setOf(name))
            1, 2 -> network.heal()
            3 -> network.loseOneSided(name, (names - name).random(random))
            4 -> {
                network.crash(name)
                start(name)
            }
            5 -> fleet.directory.roster(name).agents.randomOrNull(random)?.let(fleet::gone)
            else -> fleet.came("agent${++agents}")
        }
        if (random.nextBoolean()) network.run() else network.advance(random.nextLong(1000))
    }

    /** Ends all disturbances, and has each computer compare what it knows with others, [times] times. */
    fun calmDown(times: Int) {
        isQuiet = true
        network.heal()
        network.advance(10_000)
        repeat(times) {
            running.values.forEach { (fleet, _) -> fleet.compare(random) }
            network.advance(1000)
        }
    }

    /** The agents that each computer knows, with their computers. */
    fun known(): Map<String, Map<String, String>> = running.mapValues { (_, computer) -> computer.first.directory.agents }

    fun theirOwn(): Map<String, String> =
        running.flatMap { (name, computer) -> computer.first.directory.roster(name).agents.map { it to name } }.toMap()

    override fun close() = running.values.forEach { (_, takeover) -> takeover.close() }

    private object NoAgents : LeasedAgents {
        override fun start(agent: String, reign: Reign, mind: MindNews?) = Unit
        override fun stop(agent: String) = Unit
    }

    private companion object {
        val LOG: Logger = Logger.getLogger("argo.test.fleet").apply { level = Level.OFF }
    }
}

/** What a computer of a fleet knows of the others. */
class MissedNewsSpec : FunSpec({
    test("whatever news are missed while computers part, end and begin anew, in the end all know all agents of all") {
        checkAll(60, Arb.int()) { seed ->
            Computers(listOf("a", "b", "c", "d"), Random(seed)).use { computers ->
                repeat(40) { computers.disturb() }
                computers.calmDown(20)
                withClue("seed $seed") { computers.known().values.distinct() shouldBe listOf(computers.theirOwn()) }
            }
        }
    }
})
