package samples.carrier

import javino.LineClock
import javino.sim.Sketch
import javino.wire.BoardAction
import samples.carrier.Carrier.Direction
import kotlin.math.roundToInt
import kotlin.time.Duration.Companion.nanoseconds
import kotlin.time.DurationUnit

/**
 * A robot on a straight track with a can at its end. The robot can drive to the can, grip it and bring it back. The robot's three boards
 * share this object. Safe for use by several threads.
 */
internal class Carrier(private val clock: LineClock) {
    private var moving = Direction.NO
    private var since = clock.nanos()
    private var wayBefore = 0.0
    private var hand = Hand.OPEN
    private var can: Double? = CAN_CM // the distance of the can from the start in cm, or null while it is in the hand

    @get:Synchronized
    val direction: Direction get() = moving

    /** The robot's distance from its start in cm, at least 0. */
    @get:Synchronized
    val way: Double
        get() = (wayBefore + moving.sign * SPEED_CM_S * (clock.nanos() - since).nanoseconds.toDouble(DurationUnit.SECONDS))
            .coerceIn(0.0, can ?: CAN_CM)

    @get:Synchronized
    val grasp: Hand get() = hand

    /** The distance to the can in front of the robot in cm, or [FAR_CM] while the can is in the hand. */
    @get:Synchronized
    val free: Double get() = can?.let { it - way } ?: FAR_CM

    @Synchronized
    fun move(direction: Direction) {
        wayBefore = way
        since = clock.nanos()
        moving = direction
    }

    /** Closes the hand. If the can is near enough, the hand grips it. */
    @Synchronized
    fun grip() {
        if (hand == Hand.FULL) return
        hand = if (free <= REACH_CM) Hand.FULL else Hand.CLOSED
        if (hand == Hand.FULL) {
            move(moving)
            can = null
        }
    }

    /** Opens the hand, and puts a can in it down in front of the robot. */
    @Synchronized
    fun release() {
        if (hand == Hand.FULL) {
            move(moving)
            can = way + REACH_CM
        }
        hand = Hand.OPEN
    }

    /** A direction. [word] is its name in percepts. */
    enum class Direction(val word: String, val sign: Int) {
        FORWARD("forward", 1),
        BACKWARD("backward", -1),
        NO("no", 0),
    }

    /** A state of the robot's hand. [word] is its name in percepts. */
    enum class Hand(val word: String) {
        OPEN("open"),
        CLOSED("closed"),
        FULL("full"),
    }

    companion object {
        const val CAN_CM = 60.0

        const val REACH_CM = 12.0

        /** The distance reading in cm if nothing is in front of the robot. */
        const val FAR_CM = 200.0

        const val SPEED_CM_S = 20.0
    }
}

/** The robot of the three boards in this program. */
private val carrier by lazy { Carrier(LineClock.system()) }

/** A simulated board of the robot. [deeds] are its actions, by name. The board logs its actions. */
abstract class CarrierBoard internal constructor(private val name: String, private vararg val deeds: Pair<String, () -> Unit>) : Sketch {
    final override fun name() = name

    final override fun actions() = deeds.map { BoardAction(it.first, 0) }

    final override fun act(command: String): Boolean {
        System.getLogger("samples.$name").log(System.Logger.Level.INFO, command)
        return deeds.toMap()[command]?.invoke() != null
    }
}

/**
 * `sim:wheels`, the board with the wheels in the sample `three-boards`. The actions are `forward`, `backward` and `halt`. The percepts are
 * `moving(forward)`, `moving(backward)` or `moving(no)`, and `way(Cm)` from the start.
 */
class WheelsBoard : CarrierBoard(
    "wheels", "forward" to { carrier.move(Direction.FORWARD) }, "backward" to { carrier.move(Direction.BACKWARD) },
    "halt" to { carrier.move(Direction.NO) },
) {
    override fun percepts() = listOf("moving(${carrier.direction.word})", "way(${carrier.way.roundToInt()})")
}

/** `sim:sensors`, the board with the distance sensor. The percept is `dist(front,Cm)`. */
class SensorsBoard : CarrierBoard("sensors") {
    override fun percepts() = listOf("dist(front,${carrier.free.roundToInt()})")
}

/**
 * `sim:arm`, the board with the hand. The actions are `grip`, `release` and `halt`. The percept is `hand(open)`, `hand(closed)` or
 * `hand(full)`.
 */
class ArmBoard : CarrierBoard(
    "arm", "grip" to { carrier.grip() }, "release" to { carrier.release() },
    "halt" to {}, // the hand moves at once and cannot be halted
) {
    override fun percepts() = listOf("hand(${carrier.grasp.word})")
}
