package benchmarks.boards

import argo.testkit.TestAgent
import argo.testkit.agentOf
import benchmarks.Distribution
import benchmarks.stops.CYCLE_TIME
import benchmarks.stops.StopCourse
import benchmarks.stops.UnoOnLine
import benchmarks.stops.WatchedRobot
import javino.Frame
import kotlin.random.Random
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/** A fault of one board while the others are measured. */
internal enum class Trouble(val title: String) {
    KILLED("is killed"),
    HANGS("hangs"),
    FLOODS("floods"),
}

/**
 * One agent on simulated Unos with the baud rates [bauds], in virtual time. Each Uno has twelve changing sensors. The sensing interval is
 * 20 ms. Each Uno drives a robot of its own, which the agent stops at a limit.
 */
internal class Trio(private val bauds: List<Int>) : AutoCloseable {
    private val unos = bauds.associateWith { UnoOnLine(StopCourse(it)) }
    private val healthy = bauds.toMutableList()

    private val agent: TestAgent = agentOf(program()) {
        name = "robot"
        cycleTime = CYCLE_TIME
        for ((baud, uno) in unos) board(port(baud)).leadsTo(uno::open)
    }

    /** Gives the board at the rate [baud] this [trouble]. The robot of that board is no longer measured. */
    fun have(trouble: Trouble, baud: Int) {
        healthy -= baud
        val uno = unos.getValue(baud)
        when (trouble) {
            Trouble.KILLED -> {
                agent.board(port(baud)).disconnects()
                uno.disconnects()
            }
            Trouble.HANGS -> uno.hangs()
            Trouble.FLOODS -> uno.floods(FLOOD)
        }
        agent.after(SETTLING).shouldBelieve("stale(${port(baud)})")
    }

    /**
     * Makes the agent stop each robot [times] times. Returns the reactions by baud rate. The robots cross the limit at times that are
     * spread evenly over the sensing interval. Random times would make the medians vary more than the boards differ.
     */
    fun stop(times: Int, seed: Long): Map<Int, Reactions> {
        val random = Random(seed)
        val made = healthy.associateWith { ArrayList<Reactions.One>() }
        val phases = bauds.associateWith { List(times) { ((it + random.nextDouble()) * INTERVAL_NANOS / times).toLong() }.shuffled(random) }
        repeat(times) { i -> round(random) { phases.getValue(it)[i] }.forEach { (baud, one) -> made.getValue(baud) += one } }
        return made.mapValues { (_, ones) -> Reactions(ones) }
    }

    private fun round(random: Random, phase: (Int) -> Long): Map<Int, Reactions.One> {
        for (baud in bauds) { // lost boards also draw random numbers, so that all runs are equal
            val millimetres = WatchedRobot.LIMIT_MM + MM_AN_INTERVAL * random.nextInt(WAY_INTERVALS, 2 * WAY_INTERVALS)
            if (baud in healthy) robot(baud).place(millimetres) { it + Math.floorMod(phase(baud) - it, INTERVAL_NANOS) }
        }
        for (baud in healthy) agent.shouldBelieve("${name(baud)}::dist(f,X) & X > ${WatchedRobot.LIMIT_MM}", within = PATIENCE)
        agent.after(SHORTLY * random.nextDouble())
        healthy.forEach { unos.getValue(it).timeline.clear() }
        for (baud in healthy) agent.hears("bench", "achieve", "go(${name(baud)})")
        val end = agent.now + PATIENCE
        while (healthy.any { robot(it).stoppedAt == null }) {
            check(agent.now < end) {
                "a robot has not stopped; the agent believes ${agent.beliefs} and intends ${agent.intentions}\n${agent.log}"
            }
            agent.after(LOOK)
        }
        val ones = healthy.associateWith(::one)
        agent.after(SHORTLY)
        return ones
    }

    private fun one(baud: Int): Reactions.One {
        val crossedAt = checkNotNull(robot(baud).crossedAt)
        return Reactions.One(checkNotNull(robot(baud).stoppedAt) - crossedAt, unos.getValue(baud).timeline.since(crossedAt))
    }

    private fun robot(baud: Int): WatchedRobot =
        checkNotNull(unos.getValue(baud).robotOrNull) { "the agent has not opened its ports\n${agent.log.joinToString("\n")}" }

    private fun program(): String {
        val ports = bauds.joinToString { "port(${port(it)},[as(${name(it)}),baud($it),protocol(2)])" }
        return """
            !start.
            +!start <- argo.ports([$ports]); argo.limit($INTERVAL_MS); argo.percepts(open).
            +!go(B) <- +drives(B); !front(B).
        """.trimIndent() + bauds.map(::name).joinToString("") {
            "\n+!front($it) <- argo.act($it::front)." +
                "\n+$it::dist(f,X) : X <= ${WatchedRobot.LIMIT_MM} & drives($it) <- -drives($it); argo.act($it::stop)."
        }
    }

    override fun close() {
        agent.close()
        unos.values.forEach { it.close() }
    }

    private companion object {
        const val INTERVAL_MS = 20
        const val INTERVAL_NANOS = INTERVAL_MS * 1_000_000L
        const val MM_AN_INTERVAL = (INTERVAL_NANOS / WatchedRobot.MILLIMETRE_NANOS).toInt()
        const val WAY_INTERVALS = 10
        val LOOK = 5.milliseconds
        val SHORTLY = 200.milliseconds
        val SETTLING = 3.seconds
        val PATIENCE = 20.seconds

        /** A version 1 message without a request. */
        val FLOOD: ByteArray = Frame.of((1..12).joinToString(";", postfix = ";") { "dist($it,1)" }).toBytes()

        fun name(baud: Int) = "at$baud"

        fun port(baud: Int) = "uno$baud"
    }
}

/** The times of one robot from the limit to the stop. */
internal class Reactions(private val ones: List<One>) {
    /** The time from the limit to the stop in ns. [timeline] shows the robot's line in that time. */
    class One(val nanos: Long, val timeline: String)

    val distribution: Distribution get() = Distribution(LongArray(ones.size) { ones[it].nanos })

    val worst: String get() = ones.maxBy { it.nanos }.timeline
}
