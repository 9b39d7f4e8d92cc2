package argo.tools.exploring

import argo.tools.Output
import argo.tools.argo
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** Tests `explore` as a user runs it, each exploration in its own process. */
class ExploreCommandSpec : FunSpec({
    val folder = tempdir().toPath()
    val classPath = System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")
    val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
    val quick = listOf("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC")

    fun run(vararg arguments: String, path: String = System.getenv("PATH"), environment: Map<String, String> = emptyMap()): Output {
        val (out, err) = List(2) { createTempFile(folder, "output") }
        val process = ProcessBuilder(listOf(java) + quick + arguments).directory(folder.toFile())
            .redirectOutput(out.toFile()).redirectError(err.toFile()).apply { environment() += environment + ("PATH" to path) }.start()
        check(process.waitFor(5, TimeUnit.MINUTES)) { "${arguments.toList()} does not end" }
        return Output(process.exitValue(), out.readText(), err.readText())
    }

    fun explore(vararg arguments: String, path: String = System.getenv("PATH")): Output =
        run(
            "-cp", classPath, "argo.tools.MainKt", "explore", *arguments, path = path,
            environment = mapOf("JDK_JAVA_OPTIONS" to quick.joinToString(" ")), // for the program that explores, too
        )

    /** Writes a robot that does not stop without percepts. With [isMended], it stops. */
    fun robot(isMended: Boolean) = folder.resolve("robot.asl").writeText(
        """
        !start.
        +!start <- argo.port(ttyACM0); argo.percepts(open); !drive.
        -!start <- .wait(500); !start.
        +!drive : ${if (isMended) "argo.age(dist(front,D), Ms) & Ms < 500" else "dist(front,D)"} & D > 30 <- !send(front); .wait(300); !drive.
        +!drive <- !send(stop); .wait(300); !drive.
        +!send(C) : last(C).
        +!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
        -!send(C) <- -last(_); .print(C, " failed").
        """.trimIndent(),
    )

    val board = arrayOf("--board", "ttyACM0 dist(front,5..200)")
    val blind = arrayOf("--rule", "stopsWhenBlind(stop,[front])")

    /** Makes a folder for `PATH` with a `kotlinc` that runs the compiler on the class path. */
    fun kotlinc(): Path = folder.resolve("bin").createDirectories().also { bin ->
        val script = bin.resolve("kotlinc")
        script.writeText("#!/bin/sh\nexec '$java' -cp '$classPath' org.jetbrains.kotlin.cli.jvm.K2JVMCompiler -no-stdlib \"$@\"\n")
        script.toFile().setExecutable(true)
    }

    test("a fault is found, and its spec compiles, fails, and passes when the agent is mended").config(tags = thorough) {
        robot(isMended = false)
        val found = explore("robot.asl", *board, *blind, "--spec", "Blind.kt", "--runs", "200")
        withClue(found) {
            found.status shouldBe 1
            found.out shouldContain "the rule \"stops when blind\" is broken"
            found.out shouldContain "class RobotStopsWhenBlindSpec : FunSpec({"
        }
        val compiled = run(
            "-cp", classPath, "org.jetbrains.kotlin.cli.jvm.K2JVMCompiler", "-no-stdlib", "-classpath", classPath, "-d", "spec", "Blind.kt",
        )
        withClue(compiled) { compiled.status shouldBe 0 }
        fun spec() = run(
            "-cp", "spec${File.pathSeparator}$classPath", "io.kotest.engine.launcher.MainKt", "--spec", "RobotStopsWhenBlindSpec",
        )
        val failing = spec()
        withClue(failing) {
            failing.status shouldNotBe 0
            failing.out shouldContain "the rule \"stops when blind\" is broken"
        }
        robot(isMended = true)
        val passing = spec()
        withClue(passing) { passing.status shouldBe 0 }
    }

    test("an agent that keeps the rules") {
        robot(isMended = true)
        val few = arrayOf("--runs", "1", "--seed", "7", "--faults", "cables,silence", "--without", "neverFloods")
        val kept = explore("robot.asl", *board, *blind, *few)
        withClue(kept) {
            kept.status shouldBe 0
            kept.out shouldContain "no rule was broken in 3 runs" // a random run and two without events
        }
    }

    test("boards and rules in Kotlin").config(tags = thorough) {
        robot(isMended = false)
        folder.resolve("boards.kt").writeText(
            """
            package course

            import argo.exploring.*

            fun Exploration.boards() {
                board("ttyACM0") { sensor("dist(front,%d)", 5..200) }
                rules(rule("never drives") { run -> run.trace.firstOrNull { it is Issued && it.command == "front" }?.let { Breach(it.at, "it drives") } })
            }
            """.trimIndent(),
        )
        val found = explore("robot.asl", "--boards", "boards.kt", "--spec", "Drives.kt", path = "${kotlinc()}:${System.getenv("PATH")}")
        withClue(found) {
            found.status shouldBe 1
            found.out shouldContain "the rule \"never drives\" is broken"
            folder.resolve("Drives.kt").readText() shouldContain "import course.boards\n"
        }
    }

    test("a file that kotlinc refuses, and no kotlinc").config(tags = thorough) {
        robot(isMended = false)
        folder.resolve("broken.kt").writeText("fun Exploration.boards() {")
        val refused = explore("robot.asl", "--boards", "broken.kt", path = "${kotlinc()}:${System.getenv("PATH")}")
        withClue(refused) {
            refused.status shouldBe 3
            refused.err shouldContain "kotlinc does not compile broken.kt"
        }
        val missing = explore("robot.asl", "--boards", "broken.kt", path = "/nowhere")
        withClue(missing) {
            missing.status shouldBe 3
            missing.err shouldContain "--boards BrokenKt"
        }
    }

    test("a Java machine that cannot start has found nothing") {
        robot(isMended = false)
        val broken = run(
            "-XX:+IgnoreUnrecognizedVMOptions", "-cp", classPath, "argo.tools.MainKt", "explore", "robot.asl", *board,
            environment = mapOf("JDK_JAVA_OPTIONS" to "-XX:+NoSuchOption"), // the program that starts the exploration ignores this option
        )
        withClue(broken) {
            broken.status shouldBe 3
            broken.err shouldContain "nothing was explored: the Java machine for it has ended with status 1."
        }
    }

    test("what is no exploration is refused in words") {
        robot(isMended = false)
        val refused = explore("robot.asl", *board, "--faults", "rain")
        withClue(refused) {
            refused.status shouldBe 2
            refused.err shouldContain "there is no fault rain; there are cables"
        }
        argo("explore", "robot.asl").err shouldContain "describe the agent's board"
        argo("explore", "robot.asl", *board, "--time", "0").err shouldContain "--time is from 1 to"
        folder.listDirectoryEntries("*Spec.kt").shouldBeEmpty()
    }
})

private val thorough = setOf(NamedTag("Thorough"))
