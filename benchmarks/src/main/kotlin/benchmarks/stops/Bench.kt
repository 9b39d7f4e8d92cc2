package benchmarks.stops

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.isExecutable
import kotlin.io.path.toPath

/** The files of the bench of stops: the output of `make bench` in `javino-arduino`, and sources. */
internal object Bench {
    private val home: Path = generateSequence(Bench::class.java.protectionDomain.codeSource.location.toURI().toPath()) { it.parent }
        .firstOrNull { it.resolve("javino-arduino").isDirectory() } ?: Path.of("")

    val simulator: Path = home.resolve("javino-arduino/build/simulator")

    val agents: Path = home.resolve("experiment/agent")

    /** Returns the compiled sketch, which need not exist. */
    fun elf(sketch: String, baud: Int, loopMs: Int): Path = home.resolve("javino-arduino/build/bench/$sketch-$baud-$loopMs.elf")

    /** Returns true if the simulator and the sketches for [courses] have been built. */
    fun isBuilt(courses: Collection<StopCourse>): Boolean = simulator.isExecutable() && courses.all { Files.exists(it.elf) }
}
