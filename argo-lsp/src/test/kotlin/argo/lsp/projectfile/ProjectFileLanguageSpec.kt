package argo.lsp.projectfile

import argo.lsp.Editor
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

/** In the texts of these tests, a `§` is the cursor. */
class ProjectFileLanguageSpec : FunSpec({
    val folder = tempdir().toPath()
    val uri = folder.resolve("robot.mas2j").toUri().toString()
    folder.resolve("robot.mas2j").writeText("MAS robot { agents: scout; aslSourcePath: \"src/agt\"; }")
    folder.resolve("src/agt").createDirectories().resolve("scout.asl").writeText("!start.\n+!start.\n")

    fun <T> at(marked: String, ask: Editor.(Int) -> T): T = Editor().use { editor ->
        editor.open(uri, marked.replace("§", ""))
        editor.ask(marked.indexOf('§'))
    }

    fun words(marked: String): List<String> = at(marked) { completions(uri, it).map { item -> item.label } }

    test("options, their values and the architecture are completed") {
        words("MAS m { agents: a [argo_§] ; }") shouldContainAll listOf("argo_view", "argo_ros", "argo_sensing")
        words("MAS m { agents: a [argo_sensing=§] ; }") shouldContainExactly listOf("fresh", "every", "in_cycle")
        words("MAS m { agents: a agentArchClass §; }") shouldContainExactly listOf("argo.Arch")
        words("MAS m { ag§ }") shouldContainAll listOf("agents", "aslSourcePath")
        words("MAS m { agents: a [beliefs=\"b(§)\"]; }").shouldBeEmpty()
    }

    test("the options are those that a check knows") {
        val known = Editor().use { editor ->
            editor.open(uri, "MAS m { agents: scout [argo_other=1] agentArchClass argo.Arch; aslSourcePath: \"src/agt\"; }")
            editor.diagnostics(uri).single().message.left.substringAfter("there are ").split(", ")
        }
        words("MAS m { agents: a [argo_§] ; }") shouldContainExactlyInAnyOrder known
    }

    test("an option has its documentation, an agent its program, and the outline the agents") {
        at("MAS m { agents: a [argo_vi§ew=8080]; }") { hover(uri, it) }.shouldNotBeNull() shouldContain "live view"
        at("MAS m { agents: sco§ut; aslSourcePath: \"src/agt\"; }") { definitions(uri, it) }.single().uri shouldEndWith "/src/agt/scout.asl"
        at("MAS m { agents: scout; other #3; }§") { outline(uri) }.map { it.name } shouldContainExactly listOf("scout", "other")
    }
})
