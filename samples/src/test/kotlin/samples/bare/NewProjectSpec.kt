package samples.bare

import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import jason.asSemantics.Agent
import org.jetbrains.kotlin.cli.common.ExitCode
import org.jetbrains.kotlin.cli.jvm.K2JVMCompiler
import samples.Program
import java.io.ByteArrayOutputStream
import java.io.File
import java.io.PrintStream
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.name
import kotlin.io.path.useDirectoryEntries

/** Compiles, tests and runs the project of `java -jar argo.jar new` as its builds do, with only its own class path. */
@Tags("Thorough")
class NewProjectSpec : FunSpec({
    val folder = tempdir().toPath()
    val avr: EnabledOrReasonIf = {
        if (ARDUINO_CORE.isDirectory()) Enabled.enabled else Enabled.disabled(
            "there is no Arduino core: ./argo firmware says what it needs",
        )
    }

    mapOf(1 to listOf("my_robot"), 2 to listOf("two_eyed_eyes", "two_eyed_lamp")).forEach { (boards, sketches) ->
        context("a project whose agent has $boards board(s):") {
            val project = folder.resolve(if (boards == 1) "my-robot" else "two-eyed")

            test("it is made, and its filter compiles") {
                val made = Program.run(
                    folder, "-jar", System.getProperty("argo.jar"), "new", project.name, "--boards", "$boards",
                    "--testkit-jar", System.getProperty("argo.testkit.jar"),
                )
                withClue(made.printed) { made.status shouldBe 0 }
                compile(project.resolve("src/main/kotlin"), project.resolve("main"), emptyList())
            }

            test("its agent runs without a board, through its filter in Kotlin") {
                val run = Program.start(
                    project, "-cp", path(main(project) + jason()), "jason.infra.local.RunLocalMAS",
                    "${project.name.replace('-', '_')}.mas2j", "--no-net",
                )
                run.use { it.awaitLine("[robot] something is ") }
            }

            test("its tests pass, and print nothing of the agent") {
                val test = project.resolve("test")
                val libraries = main(project) + listOf(project.resolve("lib/argo-testkit.jar")) + jason() + kotest()
                compile(project.resolve("src/test/kotlin"), test, libraries)
                val specs =
                    project.resolve("src/test/kotlin").useDirectoryEntries { files -> files.map { it.name.removeSuffix(".kt") }.toList() }
                specs.sorted() shouldBe listOf("RobotFiltersSpec", "RobotSpec")
                specs.forEach { spec ->
                    val run =
                        Program.run(project, "-cp", path(libraries + listOf(test)), "io.kotest.engine.launcher.MainKt", "--specs", spec)
                    withClue(run.printed) {
                        run.status shouldBe 0
                        run.printed shouldContain Regex("[234] passed")
                        run.printed shouldNotContain "INFO: "
                    }
                }
            }

            sketches.forEach { sketch ->
                test("its sketch $sketch compiles for an Uno").config(enabledOrReasonIf = avr) {
                    val source = project.resolve("sketch/$sketch/$sketch.ino")
                    val library = Path.of("../javino-arduino").toAbsolutePath().normalize()
                    val elf = folder.resolve("avr/avr/uno/$sketch.elf")
                    val make = ProcessBuilder("make", "-s", "-C", "$library", "SKETCHES=$source", "BUILD=${folder.resolve("avr")}", "$elf")
                    val run = Program.run(make)
                    withClue(run.printed) { run.status shouldBe 0 }
                    elf.exists() shouldBe true
                }
            }
        }
    }
})

private val ARDUINO_CORE = Path.of(System.getenv("ARDUINO_AVR") ?: "/usr/share/arduino/hardware/arduino/avr").resolve("cores/arduino")

private fun main(project: Path) = listOf(project.resolve("main"), project.resolve("src/main/resources"), project.resolve("lib/argo.jar"))

private fun jason(): List<Path> =
    listOf(Agent::class.java, Class.forName("javax.json.Json"), Class.forName("org.glassfish.json.JsonProviderImpl")).map(::jarOf)

/** Returns Kotest and its dependencies from this test's class path, without ARGO. */
private fun kotest(): List<Path> =
    (System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")).split(File.pathSeparator)
        .map(Path::of).filter { jar -> KOTEST.any(jar.name::startsWith) }

private val KOTEST = listOf(
    "kotest-", "kotlin-stdlib", "kotlin-reflect", "kotlinx-", "opentest4j", "java-diff-utils", "classgraph", "mordant", "jna", "diffutils",
    "annotations-",
)

private fun path(entries: List<Path>) = entries.joinToString(File.pathSeparator)

private fun compile(sources: Path, target: Path, libraries: List<Path>) {
    val messages = ByteArrayOutputStream()
    val own = libraries + listOf(Path.of(System.getProperty("argo.jar")), jarOf(Unit::class.java))
    val exit = K2JVMCompiler().exec(
        PrintStream(messages), "-no-stdlib", "-no-reflect", "-Werror", "-classpath", path(own), "-jvm-target", "17", "-d", "$target",
        "$sources",
    )
    withClue(messages) { exit shouldBe ExitCode.OK }
}
