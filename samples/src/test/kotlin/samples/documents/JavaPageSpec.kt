package samples.documents

import com.fazecast.jSerialComm.SerialPort
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldMatch
import javino.link.Link
import samples.Program
import java.io.ByteArrayOutputStream
import java.io.File
import java.nio.file.Path
import javax.tools.ToolProvider
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

/** The programs on the page on Java without agents need only the library and jSerialComm, and behave as described. */
class JavaPageSpec : FunSpec({
    val documents = Document.all(Path.of("..").toRealPath())
    fun shown(page: String) = documents.single { it.name == page }.snippets.filter { it.language == "java" }.map { it.text }
    val (backOff, writing, classic) = shown("docs/java.md")
    val libraries = listOf(Link::class.java, SerialPort::class.java)
        .joinToString(File.pathSeparator) { Path.of(it.protectionDomain.codeSource.location.toURI()).toString() }

    fun compile(vararg sources: Pair<String, String>): Path {
        val folder = tempdir().toPath()
        val files = sources.map { (name, text) -> folder.resolve("$name.java").apply { writeText(text) }.toString() }
        val messages = ByteArrayOutputStream()
        val options = listOf("-Xlint:all", "-Werror", "-cp", libraries, "-d", "$folder")
        val compiled = ToolProvider.getSystemJavaCompiler().run(null, messages, messages, *(options + files).toTypedArray())
        withClue(messages) { compiled shouldBe 0 }
        return folder
    }

    fun backOffFrom(wall: String): String {
        val classes = compile("BackOff" to backOff, "Wall" to wall)
        classes.resolve("META-INF/services").createDirectories().resolve("javino.sim.SimulatedBoard").writeText("Wall\n")
        val run = Program.run(classes, "-cp", "$libraries${File.pathSeparator}$classes", "BackOff", "sim:wall")
        withClue(run.printed) { run.status shouldBe 0 }
        return run.printed
    }

    test("the program backs off ten times") {
        val lines = backOffFrom(shown("docs/boards.md").single()).lines().filter(String::isNotBlank) shouldHaveSize 10
        lines.forEach { it shouldMatch "backed off at 7\\d cm" }
    }

    test("the program goes on where a board says nothing of what is in front") {
        val wall = shown("docs/boards.md").single()
        val saysLess = wall.replace("return List.of(\"dist", "if (cm-- % 3 == 0) return List.of();\n        return List.of(\"dist")
        (saysLess == wall) shouldBe false
        backOffFrom(saysLess)
    }

    test("the thread that writes compiles") {
        compile("Writing" to "import javino.*;\nimport javino.link.*;\nclass Writing {\nvoid show(Link board) {\n$writing\n}\n}\n")
    }

    test("the classic interface compiles") {
        compile("Classic" to "import javino.link.Javino;\nclass Classic {\nvoid show() {\n$classic\n}\n}\n")
    }
})
