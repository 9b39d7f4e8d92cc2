package benchmarks.stops

import java.nio.file.Path
import kotlin.time.Duration
import kotlin.time.Duration.Companion.microseconds

/** A sketch of `javino-arduino/bench`. */
internal enum class Firmware(val sketch: String) {
    LIBRARY("Stops"),
    FIELD("FieldStops"),
}

/**
 * A robot, a line and an agent.
 *
 * @property version the version of the protocol
 * @property loopMs the time of each `loop()` of the sketch, besides the library's work
 * @property filter the agent's filter
 * @property cycleTime the time of a reasoning cycle of the agent
 */
internal data class StopCourse(
    val baud: Int,
    val version: Int = 2,
    val firmware: Firmware = Firmware.LIBRARY,
    val loopMs: Int = 1,
    val filter: String = "none",
    val cycleTime: Duration = 100.microseconds,
) {
    val elf: Path get() = Bench.elf(firmware.sketch, baud, loopMs)

    /** The port's options as the agent gives them. */
    val options: String get() = "[baud($baud), protocol($version)]"

    override fun toString() = listOfNotNull(
        "$baud baud, version $version",
        "the field's library".takeIf { firmware == Firmware.FIELD },
        "loop() of $loopMs ms",
        "filter $filter".takeIf { filter != "none" },
        "$cycleTime a cycle".takeIf { cycleTime != 100.microseconds },
    ).joinToString()
}
