package samples.greenhouse

import javino.LineClock
import javino.PerceptKind
import javino.sim.Sketch
import javino.wire.BoardAction
import kotlin.math.PI
import kotlin.math.roundToInt
import kotlin.math.sin
import kotlin.random.Random

/**
 * The greenhouse of the sketch `Greenhouse.ino`: air, soil, sun, a pump and a vent. The sensors are noisy. The day begins at five o'clock.
 * Not safe for use by several threads at once.
 *
 * @param random draws the sensors' noise
 * @param minutes returns the time since five o'clock, which must not go back
 */
open class Greenhouse(private val random: Random, private val minutes: () -> Double) : Sketch {
    private var minute = 0 // the time of the current state
    private var isPumping = false
    private var isOpen = false

    var celsius = 14.0
        private set

    /** The water in the soil, in percent. */
    var soil = 35.0
        private set

    private val dayTime get() = minute / MINUTES_A_DAY * 2 * PI // 0 at five o'clock

    private val sun get() = sin(dayTime - 2 * PI / 24).coerceAtLeast(0.0)

    final override fun name() = "greenhouse"

    final override fun percepts(): List<String> {
        catchUp()
        return listOf(
            "temp(${(celsius + noise(0.3)).tenths()})", "soil(${(soil + noise(1.0)).roundToInt().coerceIn(0, 100)})",
            "light(${(sun * 1000 + noise(15.0)).roundToInt().coerceIn(0, 1023)})", "state(pump,${if (isPumping) "on" else "off"})",
            "state(vent,${if (isOpen) "open" else "closed"})",
        )
    }

    final override fun perceptKinds(): List<PerceptKind> = KINDS

    final override fun actions() = listOf(BoardAction("set", 2))

    override fun act(command: String): Boolean {
        catchUp()
        when (command) {
            "set(pump,on)" -> isPumping = true
            "set(pump,off)" -> isPumping = false
            "set(vent,open)" -> isOpen = true
            "set(vent,closed)" -> isOpen = false
            else -> return false
        }
        return true
    }

    private fun catchUp() {
        while (minute < minutes()) {
            val outside = 14 + 8 * sin(dayTime - PI / 4)
            celsius += (outside + sun * (if (isOpen) 5 else 22) - celsius) / 25
            soil = (soil - 0.01 - 0.06 * sun + if (isPumping) 1.5 else 0.0).coerceIn(0.0, 100.0)
            minute++
        }
    }

    private fun noise(most: Double) = random.nextDouble(-most, most)

    private companion object {
        const val MINUTES_A_DAY = 1440.0

        val KINDS: List<PerceptKind> =
            PerceptKind.parseLines("temp(C 0..100)\nsoil(% 0..100)\nlight(0..1023)\nstate(pump|vent, on|off|open|closed)")

        fun Double.tenths() = (this * 10).roundToInt() / 10.0
    }
}

private const val NANOS_A_MINUTE = 10_000_000.0

/** `sim:greenhouse`, the board of the sample `greenhouse`. The board logs its commands. A minute in the greenhouse takes 10 ms. */
class GreenhouseBoard : Greenhouse(Random(2016), lapsed(LineClock.system())) {
    override fun act(command: String): Boolean {
        System.getLogger("samples.greenhouse").log(System.Logger.Level.INFO, command)
        return super.act(command)
    }
}

/** Returns a function that gives the minutes in the greenhouse since its first call. */
private fun lapsed(clock: LineClock): () -> Double {
    val begin by lazy { clock.nanos() }
    return { (clock.nanos() - begin) / NANOS_A_MINUTE }
}
