package argo.recording

import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.Replay
import argo.recording.replay.WhatIf
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.architecture.MindInspectorWeb
import java.nio.file.Path
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteExisting
import kotlin.io.path.outputStream
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.milliseconds

/** A recording contains all files that its agent included. A replay reads no file of its working directory. */
class IncludedFilesSpec : FunSpec({
    fun shouldReplay(
        vararg files: Pair<String, String>,
        options: List<Pair<String, String>> = emptyList(),
        program: (Path) -> String,
    ): List<String> {
        val folder = tempdir().toPath().toRealPath()
        fun write(text: (String) -> String) = files.forEach { (name, before) ->
            folder.resolve(name).apply { parent.createDirectories() }.writeText(text(before))
        }
        write { it }
        val file = recorded(program(folder), { options(*options.toTypedArray()) }) { after(300.milliseconds) }
        val changes = listOf<() -> Unit>(
            { write { "changed. +!work <- .print(changed). +!run <- .print(changed)." } }, { folder.toFile().deleteRecursively() },
        )
        for (change in changes) {
            change()
            val outcome = replayOf(file)
            withClue(outcome.differences.joinToString("\n")) { outcome.differences.shouldBeEmpty() }
            outcome.cycles shouldBe outcome.recorded.toLong()
        }
        return Recording(file).use { recording -> Replay(recording).use { it.run().beliefs("agent") } }
    }

    test("with beliefs only") {
        shouldReplay("facts.asl" to "speed(3).") { """{ include("$it/facts.asl") } !work. +!work : speed(S) <- +had(S).""" } shouldContain
            "had(3)[source(self)]"
    }

    test("with plans, in a namespace, and a file that it includes itself") {
        val rules = tempdir().toPath().toRealPath().resolve("rules.asl").apply { writeText("at(5). near(X) :- at(X).") }
        shouldReplay("a/plans.asl" to """{ include("$rules") } +!work : near(X) <- +had(X).""") {
            """{ include("$it/a/plans.asl", ns) } !ns::work."""
        } shouldContain "ns::had(5)[source(self)]"
    }

    test("in a block of a namespace, and a file that there is not") {
        shouldReplay("facts.asl" to "speed(3).") {
            """{ begin namespace(x) } { include("$it/facts.asl") } { end } { include("$it/absent.asl") }
               !work. +!work : x::speed(S) <- +had(S)."""
        } shouldContain "had(3)[source(self)]"
    }

    test("as it runs, twice, where the file has changed between") {
        shouldReplay("more.asl" to "more(1). +!run <- +ran.") {
            """!work. +!work <- .include("$it/more.asl"); !run; .include("$it/more.asl", m); .wait(20); +after."""
        } shouldContain "m::more(1)[source(self)]"
    }

    test("as it runs, with beliefs only, and the project's own action after that") {
        shouldReplay("facts.asl" to "speed(3).") {
            """!work. +!work <- .include("$it/facts.asl"); .wait(20); planted.dice(X); +had(X); .print(X)."""
        }
    }

    test("as it runs, without Jason's server that shows agents") {
        MindInspectorWeb.stop() // agents of another spec may have started it
        shouldReplay("more.asl" to "more(1). { begin namespace(n) } less(1). { end }") {
            """!work. +!work <- .include("$it/more.asl"); .wait(20); +after."""
        }
        MindInspectorWeb.isRunning() shouldBe false
    }

    test("from a jar") {
        val jar = tempdir().toPath().resolve("lib.jar")
        ZipOutputStream(jar.outputStream()).use {
            it.putNextEntry(ZipEntry("facts.asl"))
            it.write("speed(4).".encodeToByteArray())
        }
        shouldReplay { """{ include("jar:file:$jar!/facts.asl") } !work. +!work : speed(S) <- +had(S).""" } shouldContain
            "had(4)[source(self)]"
    }

    test("the beliefs and goals of the .mas2j") {
        val options = listOf("beliefs" to "speed(6),slow", "goals" to "work")
        shouldReplay(options = options) { "+!work : speed(S) & slow <- +had(S)." } shouldContain "had(6)[source(self)]"
    }

    test("another program takes a file beside it first, and then those that were recorded") {
        val folder = tempdir().toPath().toRealPath()
        folder.resolve("facts.asl").writeText("speed(3).")
        val file = recorded("""{ include("$folder/facts.asl") } !work. +!work : speed(S) <- +had(S).""") { after(300.milliseconds) }
        folder.resolve("facts.asl").writeText("speed(9).")
        val other = tempdir().toPath().resolve("new.asl")
        other.writeText("""{ include("$folder/facts.asl") } !work. +!work : speed(S) <- +now(S).""")
        fun beliefs() = Recording(file).use { recording -> WhatIf(recording, "agent", other).use { it.run().beliefs } }
        beliefs() shouldContain "now(9)[source(self)]"
        folder.toFile().deleteRecursively()
        beliefs() shouldContain "now(3)[source(self)]"
    }

    test("chance in a block of a file that another program includes as it runs, and in a plan that it adds, is as recorded") {
        val folder = tempdir().toPath().toRealPath()
        folder.resolve("lib.asl").writeText("{ begin namespace(n) } +!roll : .random(R) <- +drew(R). { end }")
        val program =
            """
            !work.
            +!work <- .include("$folder/lib.asl"); !n::roll; .add_plan("+!turn : X = math.random(100) <- +turned(X)."); .wait(20); !turn.
            """.trimIndent()
        val file = recorded(program) { after(300.milliseconds) }
        fun drawn(beliefs: List<String>) = beliefs.filter { "drew(" in it || "turned(" in it }
        val recorded = Recording(file).use { recording -> Replay(recording).use { drawn(it.run().beliefs("agent")) } }
        recorded shouldHaveSize 2
        val other = folder.resolve("new.asl").apply { writeText("$program // another") }
        Recording(file).use { recording -> WhatIf(recording, "agent", other).use { drawn(it.run().beliefs) } } shouldBe recorded
    }

    test("a recorded file that another program includes takes none of the user's") {
        val folder = tempdir().toPath().toRealPath()
        folder.resolve("facts.asl").writeText("speed(3).")
        val facts = """{ include("$folder/facts.asl") }"""
        folder.resolve("lib.asl").writeText("$facts { begin namespace(n) } $facts { end }")
        val program = """{ include("$folder/lib.asl") } !work. +!work : speed(S) & n::speed(N) <- +had(S,N)."""
        val file = recorded(program) { after(300.milliseconds) }
        folder.resolve("lib.asl").deleteExisting()
        folder.resolve("facts.asl").writeText("speed(9).")
        val other = tempdir().toPath().resolve("new.asl").apply { writeText(program) }
        Recording(file).use { recording -> WhatIf(recording, "agent", other).use { it.run().beliefs } } shouldContain
            "had(3,3)[source(self)]"
    }

    test("a file that a recording does not hold is named, and looked for nowhere") {
        val folder = tempdir().toPath().toRealPath()
        folder.resolve("facts.asl").writeText("speed(3).")
        val file = made("""{ include("$folder/facts.asl") } !work. +!work <- +done.""")
        Recording(file).use { recording ->
            shouldThrow<RecordingException> { Replay(recording) }.message shouldContain
                "does not hold the file $folder/facts.asl that it includes"
        }
    }
})
