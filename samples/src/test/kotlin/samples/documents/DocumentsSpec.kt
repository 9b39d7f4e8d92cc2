package samples.documents

import argo.filters.format.JsonFilters
import argo.filters.format.XmlFilters
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldBeIn
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import jason.asSemantics.Agent
import jason.asSyntax.parser.as2j
import jason.util.Config
import org.jetbrains.kotlin.cli.common.ExitCode
import org.jetbrains.kotlin.cli.jvm.K2JVMCompiler
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.io.StringReader
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

class DocumentsSpec : FunSpec({
    val root = Path.of("..").toRealPath()
    val documents = Document.all(root)
    val snippets = documents.flatMap { it.snippets }
    fun written(language: String) = snippets.filter { it.language == language }

    test("the pages are found") {
        documents.map { it.name } shouldContainAll
            listOf("README.md", "docs/filters.md", "samples/blink/README.md", "javino-arduino/README.md", "$NEW_PROJECT/README.md")
    }

    test("the page on internal actions is the KDoc of the actions") {
        val page = root.resolve("docs/internal-actions.md")
        val expected = InternalActionsPage(root).text
        if (System.getProperty("argo.write.documents") == "true") page.writeText(expected)
        withClue("-Dargo.write.documents=true generates it") { page.readText() shouldBe expected }
    }

    test("the page on adding ARGO to a project has the logging.properties of the samples") {
        val sample = root.resolve("samples/blink/logging.properties").readText().trim()
        written("properties").single { it.document == "README.md" }.text shouldBe sample
    }

    context("its language is given, for it decides how the block is tried:") {
        snippets.forEach { test("$it") { it.language shouldBeIn LANGUAGES } }
    }

    context("links lead somewhere in") {
        documents.forEach { document -> test("$document") { document.links.filterNot(document::leadsTo).shouldBeEmpty() } }
    }

    context("Jason reads the AgentSpeak of") {
        written("agentspeak").forEach { test("$it") { readAgent(it.text) } }
    }

    context("Jason reads the agents at the head of the example") {
        root.resolve("javino-arduino/examples").listDirectoryEntries().forEach { example ->
            test(example.name) {
                val agents = agentsOf(example.resolve("${example.name}.ino").readText())
                agents.shouldNotBeEmpty()
                agents.forEach(::readAgent)
            }
        }
    }

    context("Jason reads the project of") {
        written("mas2j").forEach { test("$it") { jason.mas2j.parser.mas2j(StringReader(it.text.asProject())).mas() } }
    }

    context("there is a filter in") {
        written("xml").filter { "<PerceptionFilter" in it.text }.forEach { test("$it") { XmlFilters.read(it.text, "$it") } }
        written("json").filter { "\"rules\"" in it.text }.forEach { test("$it") { JsonFilters.read(it.text, "$it") } }
    }

    context("the versions are those that this repository is built with in") {
        val built = root.resolve("pom.xml").readText()
        written("kts").forEach { snippet ->
            test("$snippet") {
                val shown = Regex("""\d+\.\d+\.\d+""").findAll(snippet.text).map { it.value }.toList()
                withClue(shown) { shown.filterNot { "version>$it<" in built }.shouldBeEmpty() }
            }
        }
    }

    test("the coordinates of ARGO's libraries are those that ./argo install gives them") {
        val pom = root.resolve("pom.xml").readText()
        val version = Regex("<artifactId>argo</artifactId>\\s*<version>(.+?)</version>").find(pom)!!.groupValues[1]
        val libraries = libraries(root)
        val group = Regex.escape(Regex("<argo.group>(.+)</argo.group>").find(pom)!!.groupValues[1])
        val inXml = Regex("<groupId>$group</groupId><artifactId>(.+?)</artifactId><version>(.+?)</version>")
        val inGradle = Regex("\"$group:(.+?):(.+?)\"")
        val shown = (written("xml").flatMap { inXml.findAll(it.text) } + written("kts").flatMap { inGradle.findAll(it.text) })
            .map { it.groupValues[1] to it.groupValues[2] }
        shown.map { it.first }.toSet() shouldContainAll listOf("argo-arch", "argo-view", "argo-testkit")
        shown.filterNot { (name, its) -> name in libraries && its == version }.shouldBeEmpty()
    }

    context("Kotlin compiles").config(tags = thorough) {
        documents.filter { document -> document.snippets.any { it.language == "kotlin" } }.forEach { document ->
            test("$document") {
                val code = document.snippets.filter { it.language == "kotlin" }.map { it.text }
                val messages = ByteArrayOutputStream()
                val directory = tempdir()
                val exit = K2JVMCompiler().exec(
                    PrintStream(messages), "-no-stdlib", "-no-reflect", "-jvm-target", "17", "-d", directory.resolve("out").path,
                    "-classpath", System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path"),
                    directory.resolve("Snippets.kt").apply { writeText(kotlinFile(code)) }.path,
                )
                withClue("$messages") { exit shouldBe ExitCode.OK }
            }
        }
    }
})

/**
 * `text` is plain text or the output of a program. `console` is commands with their output. Other specs check the other languages:
 * CommandsSpec the commands, FirmwareSnippetsSpec `cpp` and `c`, JaCaMoSpec `jcm`, BoardsPageSpec and JavaPageSpec `java`, BoardsPageSpec
 * `python`, javino-python/tests/programs.py programs in `python` that import `javino`, RosDocumentSpec `yaml`.
 */
private val LANGUAGES = setOf(
    "agentspeak", "mas2j", "xml", "json", "kotlin", "kts", "sh", "console", "cpp", "c", "jcm", "properties", "ini", "java", "python",
    "text",
    "yaml",
)

private const val NEW_PROJECT = "argo-tools/src/main/resources/argo/tools/project"

/** Returns the agents in the head comment of a sketch, without comment marks. */
private fun agentsOf(sketch: String) = SKETCH_AGENT.findAll(sketch).map { it.groupValues[1].replace("\n//", "\n") }.toList()

private val SKETCH_AGENT = Regex("""^//   (?:agent|watcher) +(.*(?:\n// {13}.*)*)""", RegexOption.MULTILINE)

private fun readAgent(text: String) {
    Config.get()[Config.START_WEB_MI] = "false" // prevents a web server for each of these agents
    val agent = Agent().apply { initAg() }
    as2j(StringReader(text)).agent(agent)
}

/** Puts a block with only agents into a project. */
private fun String.asProject() = if ("MAS " in this) this else "MAS project {\n$this\n}"

private fun kotlinFile(code: List<String>): String {
    val (imports, rest) = code.flatMap { it.lines() }.partition { it.startsWith("import ") }
    return (imports.distinct() + rest).joinToString("\n")
}

private val thorough = setOf(NamedTag("Thorough"))
