package benchmarks.stops

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.isExecutable
import kotlin.io.path.toPath
import kotlin.time.Duration
import kotlin.time.Duration.Companion.microseconds

internal enum class Firmware(val sketch: String) {
    LIBRARY("Stops"),
    FIELD("FieldStops"),
}

/**
 * The robot, the line and the agent of one measurement.
 *
 * @property loopMs the time of each `loop()` in ms, without the library's work
 * @property cycleTime the time of a reasoning cycle
 */
internal data class StopCourse(
    val baud: Int,
    val version: Int = 2,
    val firmware: Firmware = Firmware.LIBRARY,
    val loopMs: Int = 1,
    val filter: String = "none",
    val cycleTime: Duration = CYCLE_TIME,
) {
    val elf: Path get() = Bench.elf(firmware.sketch, baud, loopMs)

    val options: String get() = "[baud($baud), protocol($version)]"

    override fun toString() = listOfNotNull(
        "$baud baud, version $version",
        "the field's library".takeIf { firmware == Firmware.FIELD },
        "loop() of $loopMs ms",
        "filter $filter".takeIf { filter != "none" },
        "$cycleTime a cycle".takeIf { cycleTime != CYCLE_TIME },
    ).joinToString()
}

/** The default time of a reasoning cycle in the benches of stops and boards. */
internal val CYCLE_TIME = 100.microseconds

/** The files for the bench of stops. `make bench` in `javino-arduino` builds them. */
internal object Bench {
    private val home: Path = generateSequence(Bench::class.java.protectionDomain.codeSource.location.toURI().toPath()) { it.parent }
        .firstOrNull { it.resolve("javino-arduino").isDirectory() } ?: Path.of("")

    val simulator: Path = home.resolve("javino-arduino/build/simulator")

    val agents: Path = home.resolve("experiment/agent")

    /** Returns the path of the compiled sketch. The file may be missing. */
    fun elf(sketch: String, baud: Int, loopMs: Int): Path = home.resolve("javino-arduino/build/bench/$sketch-$baud-$loopMs.elf")

    fun isBuilt(courses: Collection<StopCourse>): Boolean = simulator.isExecutable() && courses.all { Files.exists(it.elf) }
}
