package samples.documents

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotBeBlank
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.streams.asSequence

/** `docs/left-out.md` names a place and tests for each row, and the tests exist. */
class LeftOutPageSpec : FunSpec({
    val root = Path.of("..")
    val rows = root.resolve("docs/left-out.md").readText().lines().filter { it.startsWith("| ") && !it.startsWith("| left out") }
        .map { row -> row.split(" | ").map { it.trim('|', ' ') } }
    val specs = Files.list(root).use { modules ->
        modules.asSequence().map { it.resolve("src/test/kotlin") }.filter { it.exists() }.flatMap { folder ->
            Files.walk(folder).use { files -> files.asSequence().filter { it.name.endsWith("Spec.kt") }.toList() }
        }.groupBy { it.name.removeSuffix(".kt") }
    }

    test("there are rows") { rows.size shouldBeGreaterThan 40 }

    rows.forEach { row ->
        test("${row[0]}, ${row[1]}") {
            row.size shouldBe 4
            row[2].shouldNotBeBlank()
            row[3].split("; `").map { "`" + it.removePrefix("`") }.forEach { named ->
                val (spec, name) = checkNotNull(Regex("`(\\w+)` \"(.+)\"").matchEntire(named)) { "no test in $named" }.destructured
                withClue("$spec has no test whose name begins with: $name") {
                    specs[spec].orEmpty().joinToString("\n") { it.readText() } shouldContain "\"$name"
                }
            }
        }
    }
})
