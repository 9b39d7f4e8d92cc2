package argo.exploring

import argo.testkit.AgentSetUp
import argo.testkit.Board
import argo.testkit.TestSetUp
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * The boards of the explored agents, the events that may happen to them, and the rules: the receiver of [explore]'s last argument.
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

    /** The qualified name of the function that describes the exploration; null: not known. */
    internal var describedBy: String? = null
    internal var played: Set<Fault> = Fault.entries.toSet()
        private set

    /** The time in which events happen. The first event happens 200 ms after the run begins. */
    var eventful: Duration = 10.seconds

    /** The time for which a run continues after its last event. Some rules need this time to notice that an agent does nothing. */
    var settling: Duration = 8.seconds

    /** The largest number of events in a run. */
    var mostEvents: Int = 8

    /** The first seed. */
    var seed: Long = 0

    /** The largest number of runs. */
    var runs: Int = 1_000

    /** The time limit for all runs together, in real time. To shorten a failing run may take more time. */
    var time: Duration = 60.seconds

    /** Describes the board on [port], in the agents' notation. Each agent on `argo.Arch` gets its own board of this kind. */
    fun board(port: String, describe: ExploredBoard.() -> Unit = {}) {
        boards.getOrPut(port) { ExploredBoard() }.describe()
    }

    /** Adds a message from [sender], which is none of the agents, to [agent]. It may come at any time: see the test kit's `hears`. */
    fun message(agent: String, sender: String, performative: String, content: String) {
        messages += Hears(Duration.ZERO, agent, sender, performative, content)
    }

    /** Sets the rules to check, in place of [usualRules]. */
    fun rules(vararg rules: Rule) = rules(rules.toList())

    /** Sets the rules to check, in place of [usualRules]: `rules(usualRules() + sendsOnly(listOf("stop")))`. */
    fun rules(rules: List<Rule>) {
        kept = rules
    }

    /** Sets the faults to play; without this call all are played. If [faults] is empty, only sensors change and messages come. */
    fun faults(vararg faults: Fault) {
        played = faults.toSet()
    }

    /** Configures each agent further: options, an environment, an agent class. */
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
    /** Cables are pulled, and plugged in again. */
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

/** An explored board: the percepts that its sensors can show, and its behaviour without faults. */
@TestSetUp
class ExploredBoard internal constructor() {
    internal val sensors = ArrayList<Sensor>()
    internal val scripts = ArrayList<Board.() -> Unit>()
    internal var isVersion2 = false
        private set
    internal var known: List<String>? = null
        private set

    /**
     * Adds a sensor that shows [percept] with a whole number of [range] in place of `%d`. The sensor begins with the number [first].
     * @throws IllegalArgumentException if [percept] contains no `%d`, or the range is empty
     */
    fun sensor(percept: String, range: IntRange, first: Int = range.last) {
        require("%d" in percept) { "a sensor of numbers has %d where the number stands: dist(front,%d), not $percept" }
        require(first in range) { "$percept is from ${range.first} to ${range.last} and cannot be $first" }
        sensors += Sensor(percept, range.toList().map { percept.replace("%d", "$it") }, first - range.first, range)
    }

    /** Adds a sensor that shows one of [percepts] and begins with the first of them. An empty text means that it shows no percept. */
    fun sensor(vararg percepts: String) {
        require(percepts.size > 1) { "a sensor shows one of several percepts: sensor(\"line(on)\", \"line(off)\")" }
        sensors += Sensor(percepts.joinToString("|"), percepts.toList(), 0, null)
    }

    /** Lets the board speak version 2 of the protocol. */
    fun version2() {
        isVersion2 = true
    }

    /** Lets the board speak version 2 of the protocol and offer only these [actions]: see the test kit's `knows`. */
    fun knows(vararg actions: String) {
        isVersion2 = true
        known = actions.toList()
    }

    /**
     * Sets more of the board's behaviour with functions of the test kit: `script { takes(2.seconds, "turn") }`. Percepts shown here replace
     * the sensors. A script whose percepts depend on `commands` is a simulated robot. Called before each run.
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
 * @property range the numbers in the percepts; null: the percepts have no number
 */
internal class Sensor(val name: String, val percepts: List<String>, val first: Int, val range: IntRange?)
