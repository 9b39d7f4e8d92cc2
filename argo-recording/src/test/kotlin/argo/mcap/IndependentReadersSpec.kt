package argo.mcap

import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.engine.spec.tempfile
import io.kotest.matchers.shouldBe
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes

private val installed = Path.of("build/readers").toAbsolutePath()
private val scripts = Path.of("src/test/readers").toAbsolutePath()

/** Another implementation of the format, run by a command that reads a file. */
private class OtherReader(val name: String, private val program: Path, val command: (how: String, file: Path) -> List<String>) {
    val enabled =
        if (program.exists()) Enabled.enabled
        else Enabled.disabled("the reader of $name is missing: argo-recording/install-readers installs it")

    fun read(how: String, file: Path): List<String> {
        val process = ProcessBuilder(command(how, file)).start()
        var errors = ""
        val listening = thread { errors = process.errorStream.bufferedReader().readText() }
        val lines = process.inputStream.bufferedReader().readLines()
        check(process.waitFor(60, TimeUnit.SECONDS)) { "the reader of $name does not end" }
        listening.join()
        withClue(errors) { process.exitValue() shouldBe 0 }
        return lines
    }
}

private val readers = listOf(
    OtherReader("Python", installed.resolve("python/bin/python")) { how, file ->
        listOf("$installed/python/bin/python", "$scripts/read.py", how, "$file")
    },
    OtherReader("JavaScript", installed.resolve("node_modules/@mcap/core")) { how, file ->
        listOf("node", "$scripts/read.mjs", how, "$file", "$installed")
    },
)

@Tags("Thorough")
class IndependentReadersSpec : FunSpec({
    val others = listOf("metadata versions 0.1.0", "attachment robot.asl text/plain !start.", "")

    readers.forEach { reader ->
        test("the reader of ${reader.name} finds all by the index").config(enabledOrReasonIf = { reader.enabled }, blockingTest = true) {
            val file = tempfile(suffix = ".mcap").toPath()
            val messages = writeSmall(file).last().messages
            reader.read("whole", file) shouldBe messages + others.drop(1) + others.take(1) + "count ${messages.size}"
        }

        test("the reader of ${reader.name} finds all that is whole in a file that was cut off")
            .config(enabledOrReasonIf = { reader.enabled }, blockingTest = true) {
                val whole = tempfile(suffix = ".mcap").toPath()
                val parts = writeSmall(whole).drop(3)
                val file = tempfile(suffix = ".mcap").toPath()
                parts.zipWithNext { part, next ->
                    listOf(part.bytes, part.bytes + 1, (part.bytes + next.bytes) / 2).forEach { length ->
                        file.writeBytes(whole.readBytes().copyOf(length.toInt()))
                        withClue("the first $length bytes") { reader.read("cut", file) shouldBe others + part.messages }
                    }
                }
            }
    }

    val writers = installed.resolve("ros/bin/python")
    val areThere =
        if (writers.exists()) Enabled.enabled
        else Enabled.disabled("the writers of messages of ROS 2 are missing: argo-recording/install-readers installs them")
    test("messages of random types of ROS 2 are read as rosbags and Cyclone DDS write them")
        .config(enabledOrReasonIf = { areThere }, blockingTest = true) {
            val command = ProcessBuilder("$writers", "$scripts/cdr.py", "1000", "300")
            val process = command.redirectError(ProcessBuilder.Redirect.INHERIT).start()
            val lines = process.inputStream.bufferedReader().readLines()
            lines.size shouldBe 300
            checkCdr(lines)
        }
})
