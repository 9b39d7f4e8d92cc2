package samples.documents

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldMatch
import org.jetbrains.kotlin.cli.common.ExitCode
import org.jetbrains.kotlin.cli.jvm.K2JVMCompiler
import samples.Program
import java.io.ByteArrayOutputStream
import java.io.File
import java.io.PrintStream
import java.net.ServerSocket
import java.nio.file.Path
import javax.tools.ToolProvider
import kotlin.io.path.createDirectories
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.seconds

/** Compiles and registers the boards on the page on boards. Requests the boards' percepts and sends commands by the tools. */
@Tags("Thorough")
class BoardsPageSpec : FunSpec({
    val root = Path.of("..").toRealPath()
    val argo = Path.of(System.getProperty("argo.jar")).toRealPath()
    val snippets = Document.all(root).single { it.name == "docs/boards.md" }.snippets
    fun shown(language: String) = snippets.single { it.language == language }.text

    /** Writes the board in [language] into a project. Returns a folder for its classes, in which it is registered. */
    fun project(language: String, ending: String): Pair<Path, Path> {
        val folder = tempdir().toPath()
        val classes = folder.resolve("classes")
        classes.resolve("META-INF/services").createDirectories().resolve("javino.sim.SimulatedBoard").writeText("Wall\n")
        return folder.resolve("Wall.$ending").apply { writeText(shown(language)) } to classes
    }

    fun kotlin(): Path {
        val (source, classes) = project("kotlin", "kt")
        val messages = ByteArrayOutputStream()
        val compiled = K2JVMCompiler().exec(
            PrintStream(messages), "-no-stdlib", "-no-reflect", "-Werror", "-jvm-target", "17", "-classpath", "$argo", "-d", "$classes",
            "$source",
        )
        withClue(messages) { compiled shouldBe ExitCode.OK }
        return classes
    }

    fun java(): Path {
        val (source, classes) = project("java", "java")
        val messages = ByteArrayOutputStream()
        val compiled = ToolProvider.getSystemJavaCompiler()
            .run(null, messages, messages, "-Xlint:all", "-Werror", "-cp", "$argo", "-d", "$classes", "$source")
        withClue(messages) { compiled shouldBe 0 }
        return classes
    }

    fun tool(classes: Path, vararg words: String) =
        Program.run(classes, "-cp", "$argo${File.pathSeparator}$classes", "argo.tools.MainKt", *words)

    mapOf("Kotlin" to ::kotlin, "Java" to ::java).forEach { (language, compile) ->
        test("the board in $language is a port for who names it, answers, acts and refuses") {
            val classes = compile()
            // the wall comes nearer with each request, and a busy computer repeats one
            tool(classes, "request", "sim:wall", "getPercepts").printed.trim() shouldMatch """dist\(front,(90|8\d)\);"""
            tool(classes, "send", "sim:wall", "back").printed shouldContain "the board has taken the command"
            val refused = tool(classes, "send", "sim:wall", "fly")
            withClue(refused.printed) { refused.status shouldBe 1 }
        }
    }

    test("the board in Python answers and acts") {
        val port = ServerSocket(0).use { it.localPort }
        val program = tempdir().toPath().resolve("wall.py").apply { writeText(shown("python").replace("4000", "$port")) }
        val board = ProcessBuilder("python3", "$program").inheritIO().start()
        try {
            val monitor = arrayOf("monitor", "tcp://localhost:$port", "--count", "2", "--boot", "20000")
            eventually(60.seconds) { // the board may start to listen after the monitor's request
                val asked = Program.run(program.parent, "-jar", "$argo", *monitor)
                // the wall comes nearer with each request, and a busy computer repeats one
                withClue(asked.printed) { Regex("""s +\S+ +dist\(front,(90|8\d)\)""").findAll(asked.printed).count() shouldBe 2 }
            }
        } finally {
            board.destroy()
        }
    }
})
