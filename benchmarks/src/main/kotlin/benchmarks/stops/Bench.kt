package benchmarks.stops

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.isExecutable
import kotlin.io.path.toPath

/** What the bench of stops runs, as `make bench` in `javino-arduino` and the sources have it. */
internal object Bench {
    private val home: Path = generateSequence(Bench::class.java.protectionDomain.codeSource.location.toURI().toPath()) { it.parent }
        .firstOrNull { it.resolve("javino-arduino").isDirectory() } ?: Path.of("")

    /** The simulator. */
    val simulator: Path = home.resolve("javino-arduino/build/simulator")

    /** Where the published agent is. */
    val agents: Path = home.resolve("experiment/agent")

    /** The compiled sketch, which need not exist. */
    fun elf(sketch: String, baud: Int, loopMs: Int): Path = home.resolve("javino-arduino/build/bench/$sketch-$baud-$loopMs.elf")

    /** Whether the simulator and what [courses] need have been built. */
    fun isBuilt(courses: Collection<StopCourse>): Boolean = simulator.isExecutable() && courses.all { Files.exists(it.elf) }
}
