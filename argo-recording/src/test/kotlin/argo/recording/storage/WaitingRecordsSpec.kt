package argo.recording.storage

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicLong
import kotlin.concurrent.thread

/** Threads that offer messages rest while the writing thread is late. They rest for hours here, unless its work ends that. */
class WaitingRecordsSpec : FunSpec({
    val now = AtomicLong()
    val channel = RecordChannel("/robot/cycle", "argo.Cycle", "{}")

    fun records(maxBytes: Long = 1_000) = WaitingRecords(maxBytes, restNs = TimeUnit.HOURS.toNanos(1), nanos = now::get)

    fun WaitingRecords.offer(bytes: Int) = offer(Waiting.Message(channel, 1, bytes) { ByteArray(0) })

    fun WaitingRecords.lateWith(bytes: Int, work: () -> Unit) {
        offer(bytes) shouldBe true
        take(0) {
            now.addAndGet(TimeUnit.SECONDS.toNanos(1))
            work()
        } shouldBe true
    }

    fun awaitRest(thread: Thread) {
        while (thread.state != Thread.State.TIMED_WAITING) Thread.onSpinWait()
    }

    test("a thread rests until a late batch has been handled, and its message then has room") {
        val records = records()
        var isStored = false
        val offering = thread(start = false) { isStored = records.offer(900) }
        records.lateWith(900) {
            offering.start()
            awaitRest(offering)
        }
        offering.join()
        isStored shouldBe true
        records.take(0) { it shouldHaveSize 1 }
    }

    test("nobody rests for a batch that is in time or small, or while the writing thread waits for the disk") {
        val inTime = records()
        inTime.offer(500)
        inTime.take(0) { inTime.offer(500) shouldBe true }
        val small = records()
        small.lateWith(10) { small.offer(500) shouldBe true }
        val slow = records()
        slow.lateWith(500) { slow.atDisk { slow.offer(500) shouldBe true } }
    }

    test("what waits and what is being handled have the room together") {
        val records = records()
        records.offer(600)
        records.take(0) { records.offer(600) shouldBe false }
        records.offer(600) shouldBe true
        records.take(0) { it shouldHaveSize 2 } // the gap too
    }

    test("a thread that is interrupted rests no more and stays interrupted; after the end it is refused, but still rests") {
        val records = records()
        var isInterrupted = false
        var isStored = true
        val offering = thread(start = false) {
            records.offer(1)
            isInterrupted = Thread.interrupted()
            isStored = records.offer(1)
        }
        records.lateWith(500) {
            offering.start()
            awaitRest(offering)
            records.close()
            offering.interrupt()
            awaitRest(offering)
        }
        offering.join()
        isInterrupted shouldBe true
        isStored shouldBe false
    }
})
