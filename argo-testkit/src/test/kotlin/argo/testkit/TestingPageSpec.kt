package argo.testkit

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import java.nio.file.Path
import kotlin.io.path.readText

/** The specs on the testing page and in the tutorial run with the other specs, in `documented/`. */
class TestingPageSpec : FunSpec({
    val page = Path.of("../docs/testing.md").readText()
    val tutorial = Path.of("../docs/tutorial.md").readText()
    fun blocks(text: String, language: String): List<String> =
        Regex("```$language\\n(.*?)```", RegexOption.DOT_MATCHES_ALL).findAll(text).map { it.groupValues[1] }.toList()

    mapOf("page on testing" to page, "tutorial" to tutorial).forEach { (name, text) ->
        test("each spec that the $name shows is one that is run") {
            val shown = blocks(text, "kotlin")
            shown.shouldNotBeEmpty()
            shown.forEach { spec ->
                val named = Regex("""class (\w+Spec)""").find(spec)?.groupValues?.get(1) ?: error("a block that is no spec:\n$spec")
                spec shouldBe Path.of("src/test/kotlin/documented/$named.kt").readText()
            }
        }
    }

    test("the tutorial's agent is the one that its spec tests") {
        blocks(tutorial, "agentspeak").single() shouldBe Path.of("src/test/resources/wall.asl").readText()
    }

    test("each call in its tables is there") {
        val names = (TestAgent::class.java.methods + Board::class.java.methods).map { it.name.substringBefore('-') }.toSet()
        val called = page.lines().filter { it.startsWith("| `") }.flatMap { row ->
            Regex("""`(\w+)\(""").findAll(row.split("|")[1]).map { it.groupValues[1] }
        }
        called.shouldNotBeEmpty()
        called.filterNot { it in names } shouldBe emptyList()
    }
})
