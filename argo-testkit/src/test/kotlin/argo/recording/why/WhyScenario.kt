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
 * A sensor of a scenario: a percept with one number, which is another one in some phases.
 *
 * @property space the namespace of its board; null: there is one board
 */
internal class ScenarioSensor(
    val space: String?, private val functor: String, private val place: String, val values: List<Int>, private val filter: ScenarioFilter,
) {
    /** Returns the percept as the agent believes it. */
    fun percept(value: String) = inSpace(space, "$functor($place,$value)")

    val isConstant get() = values.distinct().size == 1

    /** Returns the phase since which it has shown its value in [phase]. */
    fun since(phase: Int): Int = (phase downTo 1).firstOrNull { values[it] != values[it - 1] } ?: 0

    fun isNewIn(phase: Int) = phase == 0 || values[phase] != values[phase - 1]

    /** Returns the frame by which its value in [phase] came. */
    fun cause(phase: Int) = since(phase).let { CausingFrame(space, it, isHeld(it)) }

    /** Returns true if the filter holds a new value of [phase] back for a part of it, since that of the phase before has just passed. */
    fun isHeld(phase: Int): Boolean =
        filter.isRated(phase) && ScenarioFilter.isLong(phase) && isNewIn(phase) && isNewIn(phase - 1)

    /** Returns the value that the agent perceives in [phase]; with [isLate], at its end, when held-back values have passed. */
    fun perceived(phase: Int, isLate: Boolean): Int = if (isLate || !isHeld(phase)) values[phase] else values[phase - 1]
}

/** The filter of a scenario. */
internal enum class ScenarioFilter {
    NONE,

    /** Drops the numbers of frames. */
    QUIET,

    /** Drops them, too, and lets each sensor pass once in [EVERY_MS]. */
    RATED,

    /** The first one until the second phase begins, then the other. */
    CHANGED,
    ;

    /** True if phases are short and long in turn. */
    val isOfRates get() = this == RATED || this == CHANGED

    /** Returns true if the filter may hold back a new value of [phase]. */
    fun isRated(phase: Int) = this == RATED || this == CHANGED && phase > 1

    companion object {
        /** The shortest time between two percepts of a sensor that pass the filter `rated`. */
        const val EVERY_MS = 500

        /** Returns true if [phase] is longer than that; the others are shorter. */
        fun isLong(phase: Int) = phase % 2 == 1
    }
}

/**
 * The first frame of a [phase] from the board in the namespace [space]; or, if its percept was held back, the frame in that phase by which
 * it passed.
 */
internal data class CausingFrame(val space: String?, val phase: Int, val isHeld: Boolean = false)

/**
 * A command that the agent of a scenario sends once.
 *
 * @property text the command
 * @property plans the plans that lead to it
 * @property phase the phase of the frame on which it is sent; null: it is not sent
 * @property root the frame with the percept that began the intention; null: a goal of the program began it
 * @property causes the frames of all percepts on which it depends
 */
internal class KnownCommand(
    val text: String, val plans: String, val phase: Int?, val root: CausingFrame?, val causes: Set<CausingFrame>,
)

/**
 * An agent and a drive of it, both drawn from [seed]. The frames that cause its commands are known. Each frame has the number of its phase,
 * and a number of its own.
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
            ScenarioFilter.isLong(phase) -> random.nextInt(1000, 1400) // held-back percepts have passed long before the next one begins
            else -> SHORT_MS
        }
    }
    private val decoy = sensors.last()

    /** The commands that the agent may send. */
    val commands: List<KnownCommand> = List(random.nextInt(1, MOST_COMMANDS + 1)) { known(it) }

    /** The agent. */
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
        val first = sensors[number] // of two plans for the same event only one is chosen
        val limit = random.nextInt(20, 180)
        val other = random.nextInt(20, 180)
        val isAtOnce = first.values[0] < limit // so that the percepts of another board are there or not yet
        val second = (sensors - decoy).filter { it.space == first.space || it.isConstant && !isAtOnce }.random(random)
        fun isLow(phase: Int) = first.values[phase] < limit
        fun isHigh(phase: Int) = second.perceived(phase, first.isHeld(phase)) > other

        /** Returns the frame of the second sensor's value that is perceived when an event of the first one comes in [phase]. */
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

    /** Returns the step that sends [command] to the first board. */
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

    /** Records the drive, and returns the file. */
    fun record(): Path = recorded(program) { drive { _, percept -> percept } }

    /**
     * Returns the commands that arrive up to [seconds] if [percept] takes the place of percepts of its kind in the phases [from] to
     * [until].
     */
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

/** The length of a short phase: some frames, and shorter than a sensor is held back. */
private const val SHORT_MS = 300

/** The longest time of a command on the line. */
private val LINE = 40.milliseconds

/** Returns [text], a percept of a board in the namespace [space], as the agent believes it. */
internal fun inSpace(space: String?, text: String) = if (space == null) text else "$space::$text"

/** The phase of this frame. */
internal val Frame.phase: Int get() = phaseOf(texts)

/** Returns the phase in which a board has shown [texts]. */
internal fun phaseOf(texts: List<String>): Int = texts.first { it.startsWith("phase(") }.removeSurrounding("phase(", ")").toInt()
