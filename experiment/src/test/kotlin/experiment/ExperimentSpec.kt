package experiment

import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.engine.spec.tempfile
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import samples.Program
import java.io.PrintWriter
import java.io.StringWriter
import java.net.URI
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readLines

/** Runs the experiment in real time as a user does. A robot stops after one or two seconds. */
class ExperimentSpec : FunSpec({
    fun start(vararg arguments: String) = Program.start("experiment.MainKt", *arguments)

    fun run(vararg arguments: String) = start(*arguments).use { it.awaitEnd() }

    fun arguments(out: Path, vararg more: String) =
        arrayOf("--smoke", "--condition", "b", "--slowdown", "1", "--jobs", "6", "--out", "$out", *more)

    test("an experiment that is interrupted keeps whole lines, and goes on with the same command").config(tags = thorough) {
        val out = tempdir().toPath().resolve("results")
        start(*arguments(out, "--seed", "5")).use { program ->
            program.awaitLine("run 0 of 12")
            program.interrupt().status shouldBe 130
        }
        out.resolve("runs").listDirectoryEntries().flatMap { it.readLines() }.forAll { JSON.decodeFromString(Entry.serializer(), it) }

        val (refused, why) = run(*arguments(out, "--seed", "6"))
        why shouldContain "the seed is 5 there and 6 was asked for"
        refused shouldBe 2

        val (status, printed) = run(*arguments(out))
        printed shouldContain "seed 5"
        printed shouldContain "report: "
        status shouldBe 0
        out.resolve("report.html").exists() shouldBe true
        val finished = collisionArchive(out).finished()
        finished shouldHaveSize 12
        finished.forAll {
            it.result.outcome shouldBe Outcome.STOPPED
            it.result.distance shouldBeLessThan it.trial.limit.toDouble()
            it.result.frames shouldBeGreaterThan 2
            it.result.sincePerceivingMs.shouldNotBeNull() shouldBeLessThan it.result.sinceLimitMs
        }
    }

    test("a robot without the front distance is refused before anybody moves it") {
        val board = tempfile("lamp", ".rec")
        board.writeText("javino-recording 1\n0\tout\tgetPercepts\n20\tin\tlight(left,200);\n")
        val (status, printed) = run("--port", "replay:$board")
        printed shouldContain "the robot on replay:$board shows no dist(f,…); it answers: light(left,200);"
        status shouldBe 2
    }

    test("the demo does not offer the experiment's filters").config(tags = setOf(NamedTag("Thorough"))) {
        // a release has both on one class path
        Program.start("samples.MainKt", "collision", "--view").use { demo ->
            val page = checkNotNull(Regex("http://127\\.0\\.0\\.1:\\d+/robot/").find(demo.awaitLine("live view: "))).value
            val offered = URI(page).resolve("filters").toURL().readText()
            offered shouldContain "keepFrontDistance" // from a file
            offered shouldNotContain "Reflex"
        }
    }

    listOf(
        arrayOf("--condition", "e") to "--condition is a, b, c, d or all, not e",
        arrayOf("--jobs", "0") to "--jobs is from 1 to 256, not 0",
        arrayOf("--slowdown", "0.5") to "--slowdown is from 1 to 1000, not 0.5",
        arrayOf("--slowdown", "NaN") to "--slowdown is from 1 to 1000, not NaN",
        arrayOf("--port", " ") to "--port names no port",
        arrayOf("--port", "sim:nowhere", "--condition", "b") to "--port: there is no simulated board sim:nowhere",
        arrayOf("--port", "ttyACM0", "--scaling") to "--scaling is for simulated robots",
        arrayOf("--port", "ttyACM0", "--slowdown", "3") to "--slowdown is for simulated robots",
        arrayOf("--port", "ttyACM0", "--jobs", "3") to "--jobs is for simulated robots",
        arrayOf("--seed", "x") to "x is not a whole number",
        arrayOf("--out", "/dev/null") to "--out /dev/null cannot be written to: /dev/null/runs: Not a directory",
    ).forEach { (arguments, why) ->
        test("${arguments.joinToString(" ")} is refused in words") {
            val printed = StringWriter()
            val status = PrintWriter(printed, true).let { program().setOut(it).setErr(it).execute(*arguments) }
            "$printed" shouldContain why
            status shouldBe 2
        }
    }
})

private val thorough = setOf(NamedTag("Thorough"))
