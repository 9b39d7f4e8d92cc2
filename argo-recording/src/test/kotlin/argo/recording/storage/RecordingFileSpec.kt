package argo.recording.storage

import argo.mcap.McapReader
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.comparables.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.channels.SeekableByteChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE_NEW
import java.nio.file.StandardOpenOption.READ
import java.nio.file.StandardOpenOption.WRITE
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.io.path.readText
import kotlin.io.path.writeText

private fun RecordSink.cycles() = channel("/robot/cycle", "argo.Cycle", """{"type":"object"}""")

private fun json(number: Int) = """{"number":$number}""".encodeToByteArray()

private fun texts(path: Path, topic: String = "/robot/cycle") =
    McapReader(path).use { read -> read.messages(topics = setOf(topic)).map { it.text }.toList() }

/** A disk with room for [bytes]. */
private class FullDisk(path: Path, private val bytes: Long) : SeekableByteChannel by FileChannel.open(path, CREATE_NEW, READ, WRITE) {
    override fun write(source: ByteBuffer): Int {
        if (position() + source.remaining() > bytes) throw IOException("No space left on device")
        return inner(source)
    }

    private val file = FileChannel.open(path, WRITE)

    private fun inner(source: ByteBuffer): Int {
        val length = file.write(source, position())
        position(position() + length)
        return length
    }

    override fun truncate(size: Long): SeekableByteChannel = apply { file.truncate(size) }
}

/** A disk whose driver has a fault. */
private class FaultyDisk(path: Path) : SeekableByteChannel by FileChannel.open(path, CREATE_NEW, READ, WRITE) {
    override fun write(source: ByteBuffer): Int = throw IllegalStateException("a fault")
}

/** A disk that writes nothing until [awake] is released. */
private class SlowDisk(private val disk: FileChannel) : SeekableByteChannel by disk {
    val awake = CountDownLatch(1)

    override fun write(source: ByteBuffer): Int {
        awake.await()
        return disk.write(source)
    }
}

class RecordingFileSpec : FunSpec({
    test("what several threads offer is stored, each thread's in its order") {
        val path = tempdir().toPath().resolve("drive.mcap")
        val threads = 3
        RecordingFile.create(path) { error(it) }.use { file ->
            file.metadata("versions", mapOf("argo" to "0.1.0"))
            file.attach("robot.asl", "text/plain", "!start.".encodeToByteArray())
            List(threads) { number ->
                thread { repeat(500) { file.offer(file.channel("/r$number/cycle", "S", "{}"), it.toLong(), json(it)) shouldBe true } }
            }.forEach(Thread::join)
        }
        McapReader(path).use { read ->
            read.problems.shouldBeEmpty()
            read.metadata.single().values shouldBe mapOf("argo" to "0.1.0")
            read.attachments.single().text shouldBe "!start."
            read.channels shouldHaveSize threads
        }
        repeat(threads) { texts(path, "/r$it/cycle") shouldBe List(500) { at -> """{"number":$at}""" } }
    }

    test("a flushed recording can be read while it goes on") {
        val path = tempdir().toPath().resolve("drive.mcap")
        RecordingFile.create(path) { error(it) }.use { file ->
            file.offer(file.cycles(), 1, json(1))
            file.flush()
            texts(path) shouldBe listOf("""{"number":1}""")
            file.offer(file.cycles(), 2, json(2))
        }
        texts(path) shouldHaveSize 2
    }

    test("a thread that is interrupted, as an agent's that Jason stops, closes the whole recording and stays interrupted") {
        val path = tempdir().toPath().resolve("drive.mcap")
        val file = RecordingFile.create(path) { error(it) }
        repeat(500) { file.offer(file.cycles(), it.toLong(), json(it)) }
        Thread.currentThread().interrupt()
        file.close()
        Thread.interrupted() shouldBe true
        texts(path) shouldHaveSize 500
    }

    test("a recording leaves an older one alone") {
        val folder = tempdir().toPath()
        folder.resolve("drive.mcap").writeText("older")
        List(2) { RecordingFile.create(folder.resolve("drive.mcap")) { error(it) }.use { file -> file.path.fileName.toString() } } shouldBe
            listOf("drive-2.mcap", "drive-3.mcap")
        folder.resolve("drive.mcap").readText() shouldBe "older"
    }

    test("on a full disk the recording ends with one warning, and is read up to its last chunk") {
        val path = tempdir().toPath().resolve("drive.mcap")
        val warnings = CopyOnWriteArrayList<String>()
        RecordingFile(path, FullDisk(path, 10_000), warnings::add).use { file ->
            val stored = ArrayList<Boolean>()
            repeat(2_000) {
                stored += file.offer(file.cycles(), it.toLong(), json(it))
                if (it % 50 == 0) file.flush()
            }
            stored.last() shouldBe false
            file.flush()
        }
        warnings shouldHaveSize 1
        warnings.single() shouldContain "No space left on device"
        warnings.single() shouldContain "The agent runs on without"
        val read = texts(path)
        read shouldBe List(read.size) { """{"number":$it}""" }
        read.size % 50 shouldBe 1
        McapReader(path).use { it.problems shouldHaveSize 1 }
    }

    test("a recording on a disk that is full from the start warns, and holds nobody up") {
        val path = tempdir().toPath().resolve("drive.mcap")
        val warnings = CopyOnWriteArrayList<String>()
        RecordingFile(path, FullDisk(path, 3), warnings::add).use { file ->
            file.flush()
            file.offer(file.cycles(), 1, json(1)) shouldBe false
        }
        warnings shouldHaveSize 1
    }

    test("a fault that is no trouble of the disk ends the recording in words, too, and holds nobody up") {
        val warnings = CopyOnWriteArrayList<String>()
        RecordingFile(Path.of("drive.mcap"), FaultyDisk(tempdir().toPath().resolve("drive.mcap")), warnings::add).use { file ->
            file.flush()
            file.offer(file.cycles(), 1, json(1)) shouldBe false
            file.trouble shouldBe warnings.single()
        }
        warnings.single() shouldContain "a fault"
    }

    test("a slow disk holds nobody up: what finds no room is a gap, in its place") {
        val path = tempdir().toPath().resolve("drive.mcap")
        val disk = SlowDisk(FileChannel.open(path, CREATE_NEW, WRITE))
        val file = RecordingFile(path, disk, { error(it) }, maxWaitingBytes = 1_000)
        val stored = (0 until 500).filter { file.offer(file.cycles(), it.toLong(), json(it)) }
        disk.awake.countDown()
        file.flush()
        file.offer(file.cycles(), 500, json(500)) shouldBe true
        file.close()
        stored.size shouldBeLessThan 500
        texts(path) shouldBe stored.plus(500).map { """{"number":$it}""" }
        texts(path, GAP_TOPIC) shouldBe
            listOf("""{"messages":${500 - stored.size},"fromNs":${stored.size},"untilNs":499}""")
        McapReader(path).use { read -> read.messages().last().text shouldBe """{"number":500}""" }
    }

    test("of a program that is killed, all is there but the last second").config(blockingTest = true) {
        val path = tempdir().toPath().resolve("drive.mcap")
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val program = ProcessBuilder(
            java, "-cp", System.getProperty("java.class.path"), "argo.recording.storage.KilledRecorderKt", path.toString(),
        ).redirectErrorStream(true).start()
        val offered = CopyOnWriteArrayList<String>()
        program.inputStream.bufferedReader().use { lines ->
            while (offered.size < 300) offered += lines.readLine() ?: error("it ended by itself: $offered")
            program.destroyForcibly().waitFor(60, TimeUnit.SECONDS)
        }
        val times = offered.map { it.toLong() }
        val stallNs = times.zipWithNext { one, next -> next - one }.max() // a busy machine also delays the file's writer
        val old = times.filter { it < times.last() - TimeUnit.SECONDS.toNanos(1) - 2 * stallNs }
        McapReader(path).use { read ->
            val stored = read.messages().map { it.logTimeNs }.toList()
            stored.take(old.size) shouldBe old
            read.problems shouldHaveSize 1
        }
    }
})
