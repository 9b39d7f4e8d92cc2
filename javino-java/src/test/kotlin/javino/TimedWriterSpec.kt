package javino

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.util.concurrent.CountDownLatch
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.Condition

private const val LIMIT_S = 20L
private const val NEVER = Long.MAX_VALUE

/** The end of a time that is over as soon as the driver has begun to write. */
private const val UNTIL_BEGUN = 1L

private fun CountDownLatch.reached() = check(await(LIMIT_S, TimeUnit.SECONDS)) { "the driver was not asked within $LIMIT_S s" }

/** A driver that takes bytes only when its gate is open. */
private class Gated : AutoCloseable, LineClock {
    val gate = CountDownLatch(1)
    val begun = CountDownLatch(1)
    val taken = CopyOnWriteArrayList<String>()
    private val driver = TimedWriter.Target { bytes ->
        begun.countDown()
        gate.reached()
        taken += bytes.decodeToString()
        check(bytes.decodeToString() != "worse") { "a driver that throws" }
        if (bytes.decodeToString() == "bad") -1 else bytes.size
    }
    val writer = TimedWriter("gated", driver, this)

    override fun nanos() = if (begun.count > 0) 0 else UNTIL_BEGUN

    override fun await(condition: Condition, nanos: Long) {
        condition.awaitNanos(TimeUnit.MILLISECONDS.toNanos(1)) // that the driver has begun is not signalled
    }

    fun write(text: String, deadline: Long = NEVER) = writer.write(text.toByteArray(), 0, text.length, deadline)

    override fun close() {
        writer.close()
        gate.countDown()
    }
}

class TimedWriterSpec : FunSpec({
    timeout = TimeUnit.SECONDS.toMillis(3 * LIMIT_S)
    blockingTest = true

    test("what the driver takes is written, what it refuses has failed") {
        Gated().use { driver ->
            driver.gate.countDown()
            driver.write("abc") shouldBe TimedWriter.Outcome.WRITTEN
            driver.write("bad") shouldBe TimedWriter.Outcome.FAILED
            driver.write("worse") shouldBe TimedWriter.Outcome.FAILED
            driver.write("abc") shouldBe TimedWriter.Outcome.WRITTEN
        }
    }

    test("a write that the driver does not take in time is too late, and the next one waits behind it") {
        Gated().use { driver ->
            driver.write("first", UNTIL_BEGUN) shouldBe TimedWriter.Outcome.TOO_LATE
            driver.write("given up", UNTIL_BEGUN) shouldBe TimedWriter.Outcome.TOO_LATE
            driver.gate.countDown()
            driver.write("second") shouldBe TimedWriter.Outcome.WRITTEN
            driver.taken shouldContainExactly listOf("first", "second")
        }
    }

    test("closing ends a write that waits") {
        Gated().use { driver ->
            val write = async { driver.write("abc") }
            driver.begun.reached()
            driver.writer.close()
            write.get(LIMIT_S, TimeUnit.SECONDS) shouldBe TimedWriter.Outcome.CLOSED
        }
    }

    test("after closing nothing is written") {
        Gated().use { driver ->
            driver.writer.close()
            driver.gate.countDown()
            driver.write("abc") shouldBe TimedWriter.Outcome.CLOSED
            driver.taken.size shouldBe 0
        }
    }

    test("the bytes are the caller's again when the write returns") {
        Gated().use { driver ->
            val bytes = "abc".toByteArray()
            driver.writer.write(bytes, 0, 3, UNTIL_BEGUN) shouldBe TimedWriter.Outcome.TOO_LATE
            bytes.fill('x'.code.toByte())
            driver.gate.countDown()
            driver.write("d") shouldBe TimedWriter.Outcome.WRITTEN
            driver.taken shouldContainExactly listOf("abc", "d")
        }
    }
})
