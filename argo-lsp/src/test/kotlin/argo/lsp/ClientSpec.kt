package argo.lsp

import com.google.gson.JsonParser
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.absolute
import kotlin.io.path.exists
import kotlin.io.path.readText

/** Tests with widely used programs from npm: a client of the protocol, Visual Studio Code's reader of grammars, a validator of schemas. */
class ClientSpec : FunSpec({
    val folder = Path.of("build/client").absolute()
    val scripts = Path.of("src/test/client").absolute()
    val there = folder.resolve("node_modules/vscode-languageserver-protocol").exists()
    val installed = if (there) Enabled.enabled else Enabled.disabled("there is no client: argo-lsp/install-client installs it")

    fun thorough(name: String, work: () -> Unit) =
        test(name).config(enabledOrReasonIf = { installed }, tags = setOf(NamedTag("Thorough"))) { work() }

    fun node(script: String, vararg arguments: String, input: String = ""): String {
        val command = listOf("node", "$scripts/$script", "$folder", *arguments)
        val process = ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start()
        process.outputStream.use { it.write(input.toByteArray()) }
        val said = process.inputStream.readBytes().decodeToString()
        process.waitFor(1, TimeUnit.MINUTES)
        return said
    }

    thorough("a session of typing in a program of a thousand lines raises no exception and ends well") {
        val java = "${System.getProperty("java.home")}/bin/java"
        val said = node("session.mjs", "150", java, "-cp", System.getProperty("java.class.path"), "argo.tools.MainKt", "lsp")
        val figures = JsonParser.parseString(said).asJsonObject
        withClue(said) {
            figures["errors"].asString shouldBe ""
            figures["status"].asInt shouldBe 0
            figures["keys"].asInt shouldBe 150
        }
    }

    thorough("the grammar of Visual Studio Code tells goals, events, actions, variables and comments apart") {
        val text = "@p1 +!go(X) : not dist(front, Cm) <- argo.act(stop); .print(\"a\"); !rest. // argo: ignore\n-light(_, 3) <- -+b."
        node("grammar.mjs", Path.of("../editors/vscode").absolute().toString(), input = text).lines() shouldContainAll listOf(
            "p1 entity.name.label", "+ keyword.operator.event", "! keyword.operator.goal", "go entity.name.function", "X variable.other",
            "not keyword.operator.logical", "dist variable.function", "front constant.other.atom", "<- keyword.operator.arrow",
            "argo.act support.function.argo", ".print support.function", "rest entity.name.function.goal",
            "// argo: ignore keyword.other.pragma", "light entity.name.function", "3 constant.numeric",
        )
    }

    thorough("the grammar of Visual Studio Code has a colour for each word of the samples") {
        val programs = Path.of("../samples").toFile().walk().filter { it.extension == "asl" && "target" !in it.path }.toList()
        programs.size shouldBeGreaterThan 5
        val text = programs.joinToString("\n") { it.readText() }
        val words = node("grammar.mjs", Path.of("../editors/vscode").absolute().toString(), input = text)
        words.lines().filter { it.endsWith(" source") && it.removeSuffix(" source").any(Char::isLetterOrDigit) }.shouldBeEmpty()
    }

    thorough("the schema of JSON takes the filters of the page, and refuses what the reader refuses") {
        val page = Path.of("../docs/filters.md").readText()
        val good = Regex("```json\\n(.*?)```", RegexOption.DOT_MATCHES_ALL).findAll(page).map { it.groupValues[1] }.toList()
        val bad = listOf(
            "{}", """{"rules": [{}]}""", """{"rules": [{"predicate": "a", "reflex": "b"}]}""", """{"rules": [], "onSwitch": "keep"}""",
            """{"rules": [{"predicate": "a", "conditions": [{"argument": 0, "annotation": "b"}]}]}""",
        )
        val lines = (good + bad).joinToString("\n") { JsonParser.parseString(it).toString() }
        val schema = Path.of("../argo-filters-dsl/src/main/resources/argo/filters/format/filter.schema.json").absolute().toString()
        val said = node("schema.mjs", schema, input = lines).trim().lines()
        said.take(good.size) shouldContainExactly good.map { "ok" }
        said.drop(good.size).forEach { it shouldNotBe "ok" }
    }
})
