package argo.recording.storage

import argo.mcap.McapReader
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.pair
import io.kotest.property.checkAll
import java.nio.file.Path
import java.time.Duration

private fun RecordSink.cycles() = channel("/robot/cycle", "argo.Cycle", "{}")

private fun times(path: Path) = McapReader(path).use { read ->
    read.problems.shouldBeEmpty()
    read.messages().map { it.logTimeNs }.toList()
}

class RecordingRingSpec : FunSpec({
    test("the last messages are kept, by their time and within the bound of bytes, and one that is too large becomes a gap") {
        val path = tempdir().toPath().resolve("last.mcap")
        val offered = Arb.list(Arb.pair(Arb.int(0..40), Arb.int(0..120)), 0..80)
        checkAll(200, offered, Arb.int(1..2000)) { steps, room ->
            val ring = RecordingRing(Duration.ofNanos(100), maxBytes = room.toLong())
            val all = steps.runningFold(0L to 0) { (time, _), (step, size) -> time + step to size }.drop(1)
            all.forEach { (time, size) -> ring.offer(ring.cycles(), time, ByteArray(size)) shouldBe true }
            ring.use { it.save(path) }
            val stored = all.map { (time, size) -> time to if (size > room) Gap.of(time).json().size else size }
            fun isKept(at: Int) = stored.drop(at).sumOf { it.second } <= room && stored[at].first >= all.last().first - 100
            val kept = stored.indices.filter(::isKept)
            times(path) shouldBe kept.map { stored[it].first }
            McapReader(path).use { read ->
                read.messages(topics = setOf(GAP_TOPIC)).map { it.logTimeNs }.toList() shouldBe
                    kept.filter { all[it].second > room }.map { all[it].first }
            }
        }
    }

    test("a ring goes on when it has been saved, and keeps what it was given at the start") {
        val folder = tempdir().toPath()
        val ring = RecordingRing(Duration.ofNanos(5))
        ring.attach("robot.asl", "text/plain", "!start.".encodeToByteArray())
        ring.metadata("versions", mapOf("argo" to "0.1.0"))
        (0L..9L).forEach { ring.offer(ring.cycles(), it, ByteArray(1)) }
        ring.save(folder.resolve("a.mcap"))
        (10L..19L).forEach { ring.offer(ring.cycles(), it, ByteArray(1)) }
        ring.save(folder.resolve("a.mcap"))
        times(folder.resolve("a.mcap")) shouldBe (14L..19L).toList()
        McapReader(folder.resolve("a.mcap")).use { read ->
            read.attachments.single().text shouldBe "!start."
            read.metadata.single().values shouldBe mapOf("argo" to "0.1.0")
        }
    }

    test("a closed ring keeps nothing") {
        val ring = RecordingRing(Duration.ofMinutes(1))
        ring.offer(ring.cycles(), 1, ByteArray(1))
        ring.close()
        ring.offer(ring.cycles(), 2, ByteArray(1)) shouldBe false
    }
})
