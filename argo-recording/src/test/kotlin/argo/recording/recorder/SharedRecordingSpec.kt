package argo.recording.recorder

import argo.mcap.McapReader
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldEndWith
import io.kotest.matchers.string.shouldStartWith
import java.io.IOException
import java.nio.file.AccessDeniedException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.FileSystemException
import java.nio.file.Path
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger

class SharedRecordingSpec : FunSpec({
    test("the last minutes that cannot be written are told by the log, with the file and the reason") {
        val lines = LinkedBlockingQueue<String>()
        val log = Logger.getAnonymousLogger().apply {
            useParentHandlers = false
            addHandler(object : Handler() {
                override fun publish(record: LogRecord) {
                    lines += record.message
                }

                override fun flush() = Unit
                override fun close() = Unit
            })
        }
        val recording = SharedRecording.join("last(1)", log)
        val folder = tempdir().toPath().resolve("gone")
        recording.save(folder)
        lines.poll(60, TimeUnit.SECONDS).shouldNotBeNull().run {
            this shouldStartWith "the last minutes cannot be written to $folder"
            this shouldEndWith ".mcap: its folder is not there"
        }
        recording.leave()
    }

    test("the reasons for a file that cannot be made hold no class of Java") {
        wordsOf(AccessDeniedException("/r/d.mcap")) shouldBe "this user may not write /r/d.mcap"
        wordsOf(FileSystemException("/r/d.mcap", null, "Read-only file system")) shouldBe "/r/d.mcap: Read-only file system"
        wordsOf(FileAlreadyExistsException("/r")) shouldBe "/r is no folder"
        wordsOf(IOException("No space left on device")) shouldBe "No space left on device"
    }

    test("a recording that has ended keeps no moment, and says so") {
        val recording = SharedRecording.join("last(2)", Logger.getAnonymousLogger())
        val channels = AgentChannels("bob", recording, { 0 }, {})
        recording.sink.giveUp("the disk is full") {}
        channels.save("a bump", 1) shouldBe false
        channels.close()
    }

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
