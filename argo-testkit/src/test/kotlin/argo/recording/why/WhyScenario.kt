package argo.recording.why

import argo.recording.recorded
import argo.testkit.TestAgent
import argo.testkit.agentOf
import java.nio.file.Path
import kotlin.random.Random
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/**
 * A sensor of a scenario. The percept has one number, which may change with the phase.
 *
 * @property space the namespace of its board, or null if there is one board
 */
internal class ScenarioSensor(
    val space: String?, private val functor: String, private val place: String, val values: List<Int>, private val filter: ScenarioFilter,
) {
    fun percept(value: String) = inSpace(space, "$functor($place,$value)")

    val isConstant get() = values.distinct().size == 1

    fun since(phase: Int): Int = (phase downTo 1).firstOrNull { values[it] != values[it - 1] } ?: 0

    fun isNewIn(phase: Int) = phase == 0 || values[phase] != values[phase - 1]

    fun cause(phase: Int) = since(phase).let { CausingFrame(space, it, isHeld(it)) }

    /** Returns true if the filter holds back a new value in [phase], since a new value passed in the phase before. */
    fun isHeld(phase: Int): Boolean =
        filter.isRated(phase) && ScenarioFilter.isLong(phase) && isNewIn(phase) && isNewIn(phase - 1)

    /**
     * Returns the value that the agent perceives in [phase]. [isLate] is true for the end of the phase, when held-back values have passed.
     */
    fun perceived(phase: Int, isLate: Boolean): Int = if (isLate || !isHeld(phase)) values[phase] else values[phase - 1]
}

internal enum class ScenarioFilter {
    NONE,

    QUIET,

    /** Drops the frame numbers, and lets each sensor pass once in [EVERY_MS]. */
    RATED,

    /** [QUIET] until the second phase, then [RATED]. */
    CHANGED,
    ;

    /** True if short and long phases alternate. */
    val isOfRates get() = this == RATED || this == CHANGED

    fun isRated(phase: Int) = this == RATED || this == CHANGED && phase > 1

    companion object {
        /** The shortest time between two percepts of a sensor that pass the filter `rated`. */
        const val EVERY_MS = 500

        /** Returns true if [phase] is longer than [EVERY_MS]. Other phases are shorter. */
        fun isLong(phase: Int) = phase % 2 == 1
    }
}

/** The first frame of a [phase] from the board in [space]. If its percept was held back, the frame of that phase with which it passed. */
internal data class CausingFrame(val space: String?, val phase: Int, val isHeld: Boolean = false)

/**
 * A command that the agent of a scenario sends at most once.
 *
 * @property text the command
 * @property plans the plans that lead to the command
 * @property phase the phase of the frame that causes it, or null if it is not sent
 * @property root the frame whose percept began the intention, or null if a goal of the program began it
 * @property causes the frames of all percepts on which it depends
 */
internal class KnownCommand(
    val text: String, val plans: String, val phase: Int?, val root: CausingFrame?, val causes: Set<CausingFrame>,
)

/**
 * A random agent and a random drive, both determined by [seed]. The frames that cause its commands are known. Each frame has a phase number
 * and a frame number.
 */
internal class WhyScenario(seed: Int) {
    private val random = Random(seed)
    private val phases = random.nextInt(3, 7)
    private val spaces: List<String?> = if (random.nextInt(3) == 0) listOf("left", "right") else listOf(null)
    private val filter = ScenarioFilter.entries.random(random)
    private val sensors = List(random.nextInt(MOST_COMMANDS + 1, MOST_COMMANDS + 4)) { sensor(it) }
    private val pausesMs = List(phases) { phase ->
        when {
            !filter.isOfRates -> random.nextInt(700, 1300)
            ScenarioFilter.isLong(phase) -> random.nextInt(1000, 1400) // held-back percepts pass long before the next phase
            else -> SHORT_MS
        }
    }
    private val decoy = sensors.last()

    val commands: List<KnownCommand> = List(random.nextInt(1, MOST_COMMANDS + 1)) { known(it) }

    val program: String = buildString {
        appendLine("!start.")
        val ports = if (spaces.size == 1) "argo.port(ttyACM0)" else "argo.ports([port(ttyACM0,[as(left)]),port(ttyACM1,[as(right)])])"
        val name = if (filter == ScenarioFilter.RATED) "rated" else if (filter != ScenarioFilter.NONE) "quiet" else "none"
        appendLine("+!start <- $ports; argo.change_filter($name); argo.percepts(open); !!watch.")
        val phase = inSpace(spaces.first(), "phase")
        if (filter == ScenarioFilter.CHANGED) appendLine("+$phase(1) <- argo.change_filter(rated); +phase_seen(1).")
        appendLine("+!watch <- .wait(150); !watch.")
        if (filter == ScenarioFilter.NONE) appendLine("+${inSpace(spaces.last(), "number(N)")} : N mod 3 == 0 <- -+seen(N).")
        appendLine("+${decoy.percept("V")} : V > 1000 <- ${acting("never")}.")
        appendLine("+$phase(N) <- +phase_seen(N).")
        commands.forEach { appendLine(it.plans) }
    }

    private fun sensor(number: Int): ScenarioSensor {
        var value = random.nextInt(0, 200)
        val values = List(phases) { value.also { if (random.nextInt(3) > 0) value = random.nextInt(0, 200) } }
        val functor = listOf("dist", "light", "temp").random(random)
        return ScenarioSensor(spaces.random(random), "$functor$number", listOf("front", "left", "back").random(random), values, filter)
    }

    private fun known(number: Int): KnownCommand {
        val act = "act$number"
        val first = sensors[number] // each command has its own sensor, since only one plan for an event is chosen
        val limit = random.nextInt(20, 180)
        val other = random.nextInt(20, 180)
        val isAtOnce = first.values[0] < limit // at the first event, the percepts of another board may be missing
        val second = (sensors - decoy).filter { it.space == first.space || it.isConstant && !isAtOnce }.random(random)
        fun isLow(phase: Int) = first.values[phase] < limit
        fun isHigh(phase: Int) = second.perceived(phase, first.isHeld(phase)) > other

        /** Returns the frame of the second sensor's value at an event of the first sensor in [phase]. */
        fun aside(phase: Int) = second.cause(if (second.isHeld(phase) && !first.isHeld(phase)) phase - 1 else phase)
        val both = (0 until phases).firstOrNull { first.isNewIn(it) && isLow(it) && isHigh(it) }
        val alone = (0 until phases).firstOrNull { first.isNewIn(it) && isLow(it) }
        val event = first.percept("V")
        val once = "not done$number"
        fun of(plans: String, phase: Int?, other: CausingFrame? = null): KnownCommand {
            val root = phase?.let(first::cause)
            return KnownCommand(act, plans, phase, root, setOfNotNull(root, other))
        }
        val send = acting(act)
        val isOtherHigh = "${second.percept("W")} & W > $other"
        return when (random.nextInt(8)) {
            0 -> of("+$event : V < $limit & $once <- +done$number; $send.", alone)
            1 -> of(
                "+$event : V < $limit & $isOtherHigh & $once <- +done$number; .wait(${random.nextInt(1, 90)}); $send.",
                both, both?.let(::aside),
            )
            2 -> of(
                "+$event : V < $limit & $once <- +done$number; !react$number(V).\n" +
                    "+!react$number(V) : V > ${limit + 1} <- ${acting("wrong")}.\n+!react$number(V) <- .wait(20); $send.",
                alone,
            )
            3 -> of("+$event : V < $limit & $once <- +done$number; +alarm$number.\n+alarm$number <- $send.", alone)
            4 -> of(
                "+$event : V < $limit & $once <- +done$number; !!react$number; .wait(300).\n+!react$number <- $send.",
                alone,
            )
            5 -> of(
                "+$event : near$number(V) & $isOtherHigh & $once <- +done$number; $send.\n" +
                    "near$number(V) :- V < $limit.",
                both, both?.let(::aside),
            )
            6 -> of(
                "+$event : V < $limit & $once <- +done$number; ?${second.percept("W")}; " +
                    "if (W > $other) { $send; } else { ${acting("other$number")}; }.",
                alone?.takeIf(::isHigh), alone?.let(::aside),
            )
            else -> polled(number, first, limit)
        }
    }

    private fun acting(command: String) = "argo.act(${inSpace(spaces.first(), command)})"

    private fun polled(number: Int, sensor: ScenarioSensor, limit: Int): KnownCommand {
        val phase = (0 until phases).firstOrNull { sensor.values[it] < limit }
        return KnownCommand(
            "act$number",
            "!poll$number.\n+!poll$number : ${sensor.percept("V")} & V < $limit <- ${acting("act$number")}.\n" +
                "+!poll$number <- .wait(100); !poll$number.",
            phase, null, setOfNotNull(phase?.let(sensor::cause)),
        )
    }

    fun record(): Path = recorded(program) { drive { _, percept -> percept } }

    /** Returns the commands up to [seconds] if [percept] replaces percepts of its kind in the phases [from] to [until]. */
    fun sentWith(percept: String, from: Int, until: Int, seconds: Double): List<String> {
        val kind = percept.substringBeforeLast(',')
        val agent = agentOf(program)
        return agent.use { driven ->
            driven.drive(seconds.seconds + LINE) { phase, it ->
                if (phase in from..until && it.substringBeforeLast(',') == kind) percept else it
            }
            driven.sent
        }
    }

    private fun TestAgent.drive(until: Duration = Duration.INFINITE, changed: (Int, String) -> String) {
        var phase = 0
        spaces.forEachIndexed { place, space ->
            var frames = 0
            board("ttyACM$place").shows { _ ->
                val shown = sensors.filter { it.space == space }.map { changed(phase, it.percept("${it.values[phase]}")) }
                shown.map { it.substringAfter("::") } + "phase($phase)" + "number(${frames++})"
            }
        }
        for (next in 0 until phases) {
            phase = next
            after(minOf(pausesMs[next].milliseconds, maxOf(until - now, Duration.ZERO)))
        }
    }
}

private const val MOST_COMMANDS = 3

/** The length of a short phase. A short phase has several frames, and is shorter than the hold-back time of a sensor. */
private const val SHORT_MS = 300

private val LINE = 40.milliseconds

/** Returns [text], a percept from the namespace [space], as the agent believes it. */
internal fun inSpace(space: String?, text: String) = if (space == null) text else "$space::$text"

internal val Frame.phase: Int get() = phaseOf(texts)

internal fun phaseOf(texts: List<String>): Int = texts.first { it.startsWith("phase(") }.removeSurrounding("phase(", ")").toInt()
