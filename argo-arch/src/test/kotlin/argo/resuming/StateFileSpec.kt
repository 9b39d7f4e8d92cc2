package argo.resuming

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith
import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

class StateFileSpec : FunSpec({
    var folders = 0
    val root = tempdir().toPath()

    fun folder(): Path = root.resolve("${++folders}").createDirectory()

    fun taken(folder: Path): StateFile = StateFile.take(folder.resolve("robot.state")).shouldNotBeNull()

    test("a file that is not there has no text; then it has the last one, and only its lock is beside it") {
        val folder = folder()
        taken(folder).use { file ->
            file.read().shouldBeNull()
            file.exchange("first, and long")
            file.exchange("second")
            file.read() shouldBe "second"
            folder.listDirectoryEntries().map { it.name } shouldContainExactlyInAnyOrder listOf("robot.state", "robot.state.lock")
        }
    }

    test("a text that was not written to its end is replaced by the next one, and was never the file's") {
        val folder = folder()
        folder.resolve("robot.state").writeText("old")
        folder.resolve("robot.state.new").writeText("half a st")
        taken(folder).use { file ->
            file.read() shouldBe "old"
            file.exchange("new")
            file.read() shouldBe "new"
        }
    }

    test("a file that cannot be exchanged stays as it is") {
        val folder = folder()
        folder.resolve("robot.state").writeText("old")
        folder.resolve("robot.state.new").createDirectory()
        taken(folder).use { file ->
            shouldThrow<IOException> { file.exchange("new") }
            file.read() shouldBe "old"
        }
    }

    test("a file is set aside under a name of its own, with its text") {
        val folder = folder()
        folder.resolve("robot.state").writeText("broken")
        taken(folder).use { file ->
            val aside = file.setAside()
            "$aside" shouldStartWith "robot.state.broken-"
            folder.resolve(aside).readText() shouldBe "broken"
            file.read().shouldBeNull()
        }
    }

    test("two agents cannot have one file; when the one has given it back, the other can") {
        val folder = folder()
        taken(folder).use { StateFile.take(folder.resolve("robot.state")).shouldBeNull() }
        taken(folder).close()
    }

    test("a file that another program has is not taken until that program has ended") {
        val folder = folder()
        val java = ProcessHandle.current().info().command().orElse("java")
        val other = ProcessBuilder(java, "-cp", System.getProperty("java.class.path"), "argo.resuming.StateHolderKt", "$folder").start()
        other.inputStream.bufferedReader().readLine() shouldBe "taken"
        StateFile.take(folder.resolve("robot.state")).shouldBeNull()
        other.destroyForcibly().waitFor()
        taken(folder).close()
    }
})
