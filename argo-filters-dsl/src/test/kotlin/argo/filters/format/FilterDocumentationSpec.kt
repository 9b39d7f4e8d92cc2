package argo.filters.format

import argo.filters.Compilation
import argo.filters.dropFilter
import argo.filters.matching.FilterSession
import argo.filters.matching.matcher
import argo.filters.xml
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.StringSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.jetbrains.kotlin.cli.common.ExitCode
import java.io.File

/** Checks that every example on the page about filters works. */
class FilterDocumentationSpec : StringSpec({
    val page = generateSequence(File("").absoluteFile) { it.parentFile }
        .map { it.resolve("docs/filters.md") }.first { it.exists() }.readText()
    fun blocks(language: String) = Regex("```$language\\n(.*?)```", RegexOption.DOT_MATCHES_ALL)
        .findAll(page).map { it.groupValues[1] }.toList().also { it.shouldNotBeEmpty() }
    val frontDistance = dropFilter("frontDistance") {
        drop("temperature")
        drop("light")
        drop("distance") { argument(0) ne "front" }
    }

    "its example is one filter in all forms" {
        XmlFilters.read(blocks("xml").first(), "page.xml") shouldBe frontDistance
        JsonFilters.read(blocks("json").first(), "page.json") shouldBe frontDistance
    }

    "its XML and JSON can be read" {
        blocks("xml").forEach { XmlFilters.read(it, "page.xml") }
        blocks("json").forEach { JsonFilters.read(it, "page.json") }
    }

    "its Kotlin compiles".config(tags = thorough) {
        val (imports, code) = blocks("kotlin").flatMap { it.lines() }.partition { it.startsWith("import ") }
        val compilation = Compilation(tempdir(), emptyList(), (imports.distinct() + code).joinToString("\n"))
        withClue(compilation) { compilation.exit shouldBe ExitCode.OK }
    }

    "its table of rules says the same in all columns" {
        val row = Regex("""\| `(<parameter.*?>|<annotation.*?>)` \| `(\{.*?})` \| `(.*?)` \|""")
        val rows = row.findAll(page).toList()
        rows.size shouldBe 6
        val kotlin = listOf(
            dropFilter("f") { drop("d") { argument(0) ne "front" } },
            dropFilter("f") { drop("d") { annotation("q") lt 0.5 } },
            dropFilter("f") { drop("d") { hasAnnotation("urgent") } },
            dropFilter("f") { drop("d") { annotation("q") { gt(0); lt(1) } } },
            dropFilter("f") { drop("d") { argument(1) lt 40 until 45 } },
            dropFilter("f") { drop("d") { argument(1) deadband 5 } },
        )
        rows.zip(kotlin).forEach { (row, expected) ->
            val (inXml, inJson) = row.destructured
            xml("<filter><predicate>d</predicate>$inXml</filter>") shouldBe expected
            JsonFilters.read("""{"rules": [{"predicate": "d", "conditions": [$inJson]}]}""", "f.json") shouldBe expected
        }
    }

    "its explanations are those that are given" {
        for (percept in listOf("distance(right,30)", "distance(front,227)")) {
            page shouldContain frontDistance.matcher().explain(percept).toString()
        }
    }

    "its example of smoothing is one filter in all forms, and is explained as it is given" {
        val steady = dropFilter("steady") {
            smooth("dist") { argument(1).outliers(3); argument(1) median 3 }
            drop("dist") { argument(1) gt 200 until 180 }
        }
        XmlFilters.read(blocks("xml").single { "<smooth>" in it }, "page.xml") shouldBe steady
        JsonFilters.read(blocks("json").single { "smooth" in it }, "page.json") shouldBe steady
        val session = FilterSession.ofTexts().also { it.switchTo(steady) }
        repeat(5) { session.perceive(listOf("dist(f,40)"), it.toLong()) }
        page shouldContain session.explain("dist(f,300)", 5).toString()
    }
})

private val thorough = setOf(NamedTag("Thorough"))
