package argo.recording.recorder

import argo.mcap.McapReader
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import java.nio.file.Path

class SharedRecordingSpec : FunSpec({
    test("of a program that is ended from outside, as by Ctrl-C, all is there").config(blockingTest = true) {
        val path = tempdir().toPath().resolve("drive.mcap")
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val program = ProcessBuilder(
            java, "-cp", System.getProperty("java.class.path"), "argo.recording.recorder.EndedRecorderKt", path.toString(),
        ).redirectError(ProcessBuilder.Redirect.DISCARD).start()
        try {
            program.inputStream.bufferedReader().use { it.readLine() } shouldBe "recorded"
        } finally {
            program.destroy()
            program.waitFor()
        }
        McapReader(path).use { read ->
            read.messages().map { it.logTimeNs }.toList() shouldBe listOf(1L)
            read.problems.shouldBeEmpty()
        }
    }
})
