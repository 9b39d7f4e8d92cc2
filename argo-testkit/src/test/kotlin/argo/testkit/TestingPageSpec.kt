package argo.testkit

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import java.nio.file.Path
import kotlin.io.path.readText

/** The specs that the page on testing shows are run with the others, from `documented/`. */
class TestingPageSpec : FunSpec({
    val page = Path.of("../docs/testing.md").readText()

    test("each spec that the page shows is one that is run") {
        val shown = Regex("```kotlin\\n(.*?)```", RegexOption.DOT_MATCHES_ALL).findAll(page).map { it.groupValues[1] }.toList()
        shown.shouldNotBeEmpty()
        shown.forEach { spec ->
            val name = Regex("""class (\w+Spec)""").find(spec)?.groupValues?.get(1) ?: error("a block that is no spec:\n$spec")
            spec shouldBe Path.of("src/test/kotlin/documented/$name.kt").readText()
        }
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
