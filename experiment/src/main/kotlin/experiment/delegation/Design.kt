package experiment.delegation

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlin.random.Random

/** The kinds of the robot's sensors, by the functors of their percepts. Each kind has a third of the sensors. */
internal val KINDS = listOf("dist", "light", "temp")

/**
 * A way to divide the work among agents: which of them sense, reason and act.
 *
 * @property word the design's name in records
 * @property boards the robot's boards, each with the kinds of its sensors. The first board has the motors
 */
@Serializable
internal enum class Design(val word: String, val title: String, val boards: List<List<String>>) {
    @SerialName("one")
    ONE("one", "one agent", listOf(KINDS)),

    /** [ONE] with a board and a line for each kind of sensor. The design separates the effect of lines from that of agents. */
    @SerialName("boards")
    BOARDS("boards", "one agent, three boards", KINDS.map(::listOf)),

    /** An ARGO agent with a board for each kind of sensor, as the paper proposes in section 5.3. */
    @SerialName("kinds")
    KINDS_APART("kinds", "an agent for each kind", KINDS.map(::listOf)),

    /** An ARGO agent senses and acts, and sends its percepts to common agents. Each common agent reasons about one kind of sensor. */
    @SerialName("delegates")
    DELEGATES("delegates", "one agent delegates", listOf(KINDS)),
}

/**
 * The work of the agents in a run, and the processors for it.
 *
 * @property processors the number of processors that the agents share
 * @property interval the sensing interval, in ms
 * @property sensors the number of the robot's sensors, a multiple of three
 * @property plans the number of plans for each kind of percept. Only the last one applies
 */
@Serializable
internal data class Load(val processors: Int, val interval: Int, val sensors: Int, val plans: Int)

/** A run of [design] under [load], in the block number [block], from 1. */
@Serializable
internal data class DelegationRun(val block: Int, val load: Load, val design: Design) {
    /** The unique name of the run, a Jason atom. */
    val id: String get() = load.run { "b${block}_p${processors}_i${interval}_s${sensors}_n${plans}_" } + design.word
}

/** The levels of the factors, and the number of blocks. A block contains each combination of levels once. */
@Serializable
internal enum class DelegationPlan(
    val blocks: Int, val processors: List<Int>, val intervals: List<Int>, val sensors: List<Int>, val plans: List<Int>,
) {
    @SerialName("full")
    FULL(5, listOf(1, 4), listOf(20, 100), listOf(12, 48, 192), listOf(1, 10, 100)),

    @SerialName("quick")
    QUICK(3, listOf(1, 4), listOf(20), listOf(12, 192), listOf(1, 100)),

    /** The shortest plan, for a test of the program. */
    @SerialName("smoke")
    SMOKE(2, listOf(4), listOf(20), listOf(12), listOf(1)),
    ;

    val loads: List<Load>
        get() = processors.flatMap { p -> intervals.flatMap { i -> sensors.flatMap { s -> plans.map { n -> Load(p, i, s, n) } } } }

    /** Returns the runs in order of blocks. The order within a block is random. */
    fun runs(seed: Long): List<DelegationRun> = (1..blocks).flatMap { block ->
        loads.flatMap { load -> Design.entries.map { DelegationRun(block, load, it) } }.shuffled(Random(31 * seed + block))
    }
}
