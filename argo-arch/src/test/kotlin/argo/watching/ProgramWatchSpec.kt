package argo.watching

import argo.jason.LIMIT
import argo.jason.LocalMas
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Path
import java.util.jar.JarEntry
import java.util.jar.JarOutputStream
import kotlin.io.path.deleteExisting

private fun watched(included: Path) = """
    { include("$included") }
    +!greet <- +greeted(old).
"""

class ProgramWatchSpec : FunSpec({
    val watch = mapOf("argo_watch" to "true")

    test("a watched agent is reloaded when its program or an included file is saved") {
        LocalMas().use { mas ->
            val program = watched(mas.file("more.asl", "+!wave <- +waved(old)."))
            mas.agent("bob", program, watch)
            mas.file("bob.asl", program.replace("old", "new"))
            eventually(LIMIT) { mas.log shouldContain "bob.asl saved" }
            mas.file("more.asl", "+!wave <- +waved(new, too).")
            eventually(LIMIT) { mas.log shouldContain "more.asl saved" }
            listOf("greet", "wave").forEach { mas.achieve("bob", it) }
            mas.awaitBelief("bob", "greeted(new)")
            mas.awaitBelief("bob", "waved(new,too)")
        }
    }

    test("a saved file with a mistake is told at its line, and the agent goes on with the program that it has") {
        LocalMas().use { mas ->
            val program = watched(mas.file("more.asl", ""))
            mas.agent("bob", program, watch)
            mas.file("bob.asl", program.replace("+greeted(old)", "+greeted("))
            eventually(LIMIT) { mas.log shouldContain "bob.asl saved, but the agent goes on as it is:" }
            mas.log shouldContain Regex("line 3")
            mas.achieve("bob", "greet")
            mas.awaitBelief("bob", "greeted(old)")
        }
    }

    test("a file that is gone is told, and the file of a filter stays watched, so that its return is noticed") {
        LocalMas().use { mas ->
            val filter = mas.file("near.xml", "<PerceptionFilter/>")
            mas.agent("bob", "!start. +!start <- argo.change_filter(near); +ready.", watch)
            mas.awaitBelief("bob", "ready")
            val sources = mas.observed("bob").sources()
            sources.map { it.fileName } shouldContain filter.fileName
            filter.deleteExisting()
            mas.observed("bob").sources() shouldBe sources
            sources.first().deleteExisting()
            eventually(LIMIT) { mas.log shouldContain "bob.asl gone, but the agent goes on as it is:" }
        }
    }

    test("an agent without a file on a disk is told not to be watched") {
        val folder = tempdir()
        JarOutputStream(folder.resolve("program.jar").outputStream()).use { jar ->
            jar.putNextEntry(JarEntry("bob.asl"))
            jar.write("!start. +!start <- +ready.".toByteArray())
        }
        LocalMas().use { mas ->
            mas.agentOf("bob", "jar:${folder.toURI()}program.jar!/bob.asl", watch)
            mas.awaitBelief("bob", "ready")
            eventually(LIMIT) { mas.log shouldContain "no file of the agent is on this computer's disk, so none is watched" }
        }
    }

    test("what is neither true nor false is told, and nothing is watched") {
        LocalMas().use { mas ->
            mas.agent("bob", "!start. +!start <- +ready.", mapOf("argo_watch" to "yes"))
            mas.awaitBelief("bob", "ready")
            mas.log shouldContain "argo_watch=yes: it is true or false; the agent's files are not watched"
        }
    }
})
