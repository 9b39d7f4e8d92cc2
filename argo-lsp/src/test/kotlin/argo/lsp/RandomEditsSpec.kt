package argo.lsp

import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import org.eclipse.lsp4j.PublishDiagnosticsParams
import java.nio.file.Path
import kotlin.io.path.readText
import kotlin.random.Random

/** Makes random edits at random places of texts. */
class RandomEditsSpec : FunSpec({
    val files = mapOf(
        "file:///nowhere/robot.asl" to Path.of("../samples/collision/robot.asl").readText(),
        "file:///nowhere/filters/near.xml" to Path.of("../samples/collision/filters/byValue.xml").readText(),
        "file:///nowhere/robot.mas2j" to Path.of("../samples/collision/collision.mas2j").readText(),
        "file:///nowhere/filters/near.json" to """{"rules": [{"predicate": "dist", "conditions": [{"argument": 0, "value": "front"}]}]}""",
    )
    val pieces = listOf(
        "", "", "(", ")", "[", "{", "}", "\"", "'", "/*", "*/", "//", "\n", "\r\n", ".", "+!", "<-", ":", "{ include(\"x.asl\") }\n", "X",
        "~",
        "<filter>", "</", "<!--", "-->", "&", ",", "\u00e9", "\uD83D\uDE00", "\u0000", "dist(front, Cm)", "argo.act(", "1e9", "\\", "\t",
    )

    /** Makes [count] edits with requests in between. Returns all published diagnostics, checked against the texts of their versions. */
    fun Editor.type(count: Int, random: Random) {
        val versions = files.keys.associateWith { HashMap<Int, String>() }
        fun note(uri: String) = versions.getValue(uri).put(version(uri), text(uri))
        fun check(said: PublishDiagnosticsParams) {
            val text = versions.getValue(said.uri)[said.version]
            withClue("${said.uri} ${said.version}") { (text != null) shouldBe true }
            val lines = text.orEmpty().split("\r\n", "\n", "\r")
            said.diagnostics.flatMap { listOf(it.range.start, it.range.end) }.forEach { place ->
                place.line shouldBeLessThanOrEqual lines.lastIndex
                place.character shouldBeLessThanOrEqual lines[place.line].length
            }
        }
        files.forEach { (uri, text) -> open(uri, text).also { note(uri) } }
        repeat(count) {
            val uri = files.keys.random(random)
            val text = text(uri)
            val begin = whole(text, random.nextInt(text.length + 1))
            val end = whole(text, (begin + if (random.nextInt(4) == 0) random.nextInt(30) else 0).coerceAtMost(text.length))
            replace(uri, begin, end, pieces.random(random))
            note(uri)
            if (it % 50 == 0) ask(uri, whole(text(uri), random.nextInt(text(uri).length + 1)))
            publications().forEach(::check)
        }
        files.keys.forEach { uri -> if (text(uri) != files[uri]) replace(uri, 0, text(uri).length, files.getValue(uri)).also { note(uri) } }
    }

    fun survives(count: Int, seed: Int) = Editor().use { editor ->
        editor.type(count, Random(seed))
        val last = files.keys.associateWith { editor.lastDiagnostics(it) }
        val fresh = Editor().use { other ->
            files.forEach { (uri, text) -> other.open(uri, text) }
            files.keys.associateWith { other.lastDiagnostics(it) }
        }
        last shouldBe fresh
        editor.messages.toList().shouldBeEmpty()
    }

    test("three hundred random edits raise no exception, and nothing is said about a text that is gone") { survives(300, seed = 1) }

    test("so do ten thousand").config(tags = setOf(NamedTag("Thorough"))) { survives(10_000, seed = 2) }
})

/** Makes each request that an editor can make for a place. */
private fun Editor.ask(uri: String, offset: Int) {
    completions(uri, offset)
    hover(uri, offset)
    definitions(uri, offset)
    references(uri, offset)
    outline(uri)
    layout(uri)
}
