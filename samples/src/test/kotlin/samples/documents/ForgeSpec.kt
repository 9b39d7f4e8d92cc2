package samples.documents

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.isExecutable
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText

/** Checks that files and settings named in a forge's configuration exist. */
class ForgeSpec : FunSpec({
    val root = Path.of("..").toRealPath()
    val forms = root.resolve(".github/ISSUE_TEMPLATE").listDirectoryEntries("*.yml").filter { it.name != "config.yml" }

    test("CI runs programs of this repository that are there") {
        val workflow = root.resolve(".github/workflows/ci.yml").readText()
        val programs = Regex("""- run: (\.\S+)""").findAll(workflow).map { it.groupValues[1] }.toList()
        programs shouldContainAll listOf(".ci/run", ".ci/long", "./gradlew")
        programs.filterNot { root.resolve(it).isExecutable() }.shouldBeEmpty()
    }

    forms.forEach { form ->
        val text = form.readText()

        test("the form ${form.name} names pages and commands that are there") {
            val pages = Regex("""[\w/]+\.md""").findAll(text).map { it.value }.toList()
            pages.filterNot { root.resolve(it).exists() }.shouldBeEmpty()
            val commands = Regex("`(.+?)`").findAll(text).map { it.groupValues[1] }.toList()
            val check = CommandCheck(root)
            withClue(commands) { commands.mapNotNull { check.problem(it.split(" ")) }.shouldBeEmpty() }
        }

        test("the form ${form.name} has what a form needs, and no field twice") {
            Regex("(?m)^(\\w+):").findAll(text).map { it.groupValues[1] }.toList() shouldBe listOf("name", "description", "labels", "body")
            val fields = Regex("(?m)^  - type: (\\w+)\n    (\\w+):").findAll(text).map { it.groupValues }.toList()
            fields.filter { (_, type, next) -> next != if (type == "markdown") "attributes" else "id" }.shouldBeEmpty()
            val ids = Regex("(?m)^    id: (\\w+)").findAll(text).map { it.groupValues[1] }.toList()
            ids.shouldNotBeEmpty()
            ids.distinct() shouldBe ids
        }
    }
})
