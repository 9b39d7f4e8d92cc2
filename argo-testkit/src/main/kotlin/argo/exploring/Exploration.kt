package argo.exploring

import argo.testkit.AgentSetUp
import argo.testkit.Board
import argo.testkit.TestSetUp
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * The boards of the explored agents, the possible events and the rules. [explore]'s last argument has an exploration as its receiver.
 *
 *     fun Exploration.boards() {
 *         board("ttyACM0") { sensor("dist(front,%d)", 5..200) }
 *         rules(stopsWhenBlind("stop", moving = listOf("front")), handlesFailures())
 *     }
 */
@TestSetUp
class Exploration internal constructor() {
    internal val boards = LinkedHashMap<String, ExploredBoard>()
    internal val messages = ArrayList<Hears>()
    internal val setUps = ArrayList<AgentSetUp.() -> Unit>()
    internal var kept: List<Rule> = usualRules()
        private set

    /** The qualified name of the function that describes the exploration, or null if it is not known. */
    internal var describedBy: String? = null
    internal var played: Set<Fault> = Fault.entries.toSet()
        private set

    /** The time span of the events. The first event happens 200 ms after the run begins. */
    var eventful: Duration = 10.seconds

    /** The time for which a run continues after its last event. Some rules need this time to detect an idle agent. */
    var settling: Duration = 8.seconds

    /** The greatest number of events in a run. */
    var mostEvents: Int = 8

    /** The first seed. */
    var seed: Long = 0

    /** The greatest number of runs. */
    var runs: Int = 1_000

    /** The time limit for all runs together, in real time. Shrinking a failing run may take additional time. */
    var time: Duration = 60.seconds

    /** Describes the board on [port]. The port is written as in agents. */
    fun board(port: String, describe: ExploredBoard.() -> Unit = {}) {
        boards.getOrPut(port) { ExploredBoard() }.describe()
    }

    /**
     * Adds a message from [sender] to [agent]. The sender is none of the explored agents. The message may arrive at any time.
     * [performative] and [content] are as in the test kit's `hears`.
     */
    fun message(agent: String, sender: String, performative: String, content: String) {
        messages += Hears(Duration.ZERO, agent, sender, performative, content)
    }

    /** Replaces [usualRules] by [rules]. */
    fun rules(vararg rules: Rule) = rules(rules.toList())

    /** Replaces [usualRules] by [rules]: `rules(usualRules() + sendsOnly(listOf("stop")))`. */
    fun rules(rules: List<Rule>) {
        kept = rules
    }

    /** Sets the possible faults. The default is all faults. Without any fault, only sensors change and messages arrive. */
    fun faults(vararg faults: Fault) {
        played = faults.toSet()
    }

    /** Configures each agent: options, an environment, an agent class. */
    fun agents(setUp: AgentSetUp.() -> Unit) {
        setUps += setUp
    }

    /** @throws IllegalArgumentException if there is nothing to explore */
    internal fun checked(): Exploration = apply {
        require(boards.isNotEmpty()) {
            "no board is described: name the port as the agent does, and what its sensors can show, as in " +
                "board(\"ttyACM0\") { sensor(\"dist(front,%d)\", 5..200) }"
        }
        require(kept.isNotEmpty()) { "there is no rule to be kept" }
        require(mostEvents > 0 && runs > 0) { "a run has 1 event or more, and there is 1 run or more" }
    }
}

/** A kind of fault that an exploration can play. */
enum class Fault {
    /** Cables are unplugged and plugged in again. */
    CABLES,

    /** Boards hang, or answer no requests. */
    SILENCE,

    /** Boards answer late. */
    SLOWNESS,

    /** Boards restart. */
    RESTARTS,

    /** Bytes arrive with wrong bits. */
    NOISE,

    /** Boards send unrequested messages. */
    FLOODS,

    /** Sensors alternate between two values. */
    FLICKER,

    /** Messages between agents arrive late and in another order. */
    LATE_MESSAGES,
}

/** An explored board: its sensors, and its behaviour without faults. */
@TestSetUp
class ExploredBoard internal constructor() {
    internal val sensors = ArrayList<Sensor>()
    internal val scripts = ArrayList<Board.() -> Unit>()
    internal var isVersion2 = false
        private set
    internal var known: List<String>? = null
        private set

    /**
     * Adds a sensor that shows [percept], with a whole number of [range] in place of `%d`. The sensor begins with the number [first].
     * @throws IllegalArgumentException if [percept] contains no `%d`, or the range is empty
     */
    fun sensor(percept: String, range: IntRange, first: Int = range.last) {
        require("%d" in percept) { "a sensor of numbers has %d where the number stands: dist(front,%d), not $percept" }
        require(first in range) { "$percept is from ${range.first} to ${range.last} and cannot be $first" }
        sensors += Sensor(percept, range.toList().map { percept.replace("%d", "$it") }, first - range.first, range)
    }

    /**
     * Adds a sensor that shows one of [percepts]. The sensor starts with the first one. An empty text means that the sensor shows no
     * percept.
     */
    fun sensor(vararg percepts: String) {
        require(percepts.size > 1) { "a sensor shows one of several percepts: sensor(\"line(on)\", \"line(off)\")" }
        sensors += Sensor(percepts.joinToString("|"), percepts.toList(), 0, null)
    }

    /** The board speaks version 2 of the protocol. */
    fun version2() {
        isVersion2 = true
    }

    /**
     * The board speaks version 2 of the protocol, and knows only these [actions]. The [actions] have the notation of the test kit's
     * `knows`.
     */
    fun knows(vararg actions: String) {
        isVersion2 = true
        known = actions.toList()
    }

    /**
     * Configures the board with functions of the test kit: `script { takes(2.seconds, "turn") }`. Percepts shown here replace the sensors.
     * A script that computes percepts from `commands` simulates a robot. [behaviour] is called before each run.
     */
    fun script(behaviour: Board.() -> Unit) {
        scripts += behaviour
    }
}

/**
 * The percepts that a sensor can show.
 *
 * @property percepts all percepts; an empty text means that the sensor shows no percept
 * @property first the index of the percept that the sensor shows first
 * @property range the numbers in the percepts, or null if the percepts have none
 */
internal class Sensor(val name: String, val percepts: List<String>, val first: Int, val range: IntRange?)
