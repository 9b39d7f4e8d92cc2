package javino

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

private const val LIMIT_S = 20L
private const val LONG_MILLIS = 20_000

private fun CountDownLatch.reached() = check(await(LIMIT_S, TimeUnit.SECONDS)) { "the driver was not asked within $LIMIT_S s" }

/** A driver that takes bytes only when its gate is open. */
private class Gated : AutoCloseable {
    val gate = CountDownLatch(1)
    val begun = CountDownLatch(1)
    val taken = CopyOnWriteArrayList<String>()
    val writer = TimedWriter("gated") { bytes ->
        begun.countDown()
        gate.reached()
        taken += bytes.decodeToString()
        check(bytes.decodeToString() != "worse") { "a driver that throws" }
        if (bytes.decodeToString() == "bad") -1 else bytes.size
    }

    fun write(text: String, timeoutMillis: Int = LONG_MILLIS) = writer.write(text.toByteArray(), 0, text.length, timeoutMillis)

    /** Writes until the driver has begun. A write that timed out before that never begins. */
    fun begin(bytes: ByteArray) {
        while (begun.count > 0) {
            writer.write(bytes, 0, bytes.size, 1) shouldBe TimedWriter.Outcome.TOO_LATE
        }
    }

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
            driver.begin("first".toByteArray())
            driver.write("given up", 1) shouldBe TimedWriter.Outcome.TOO_LATE
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
            driver.begin(bytes)
            bytes.fill('x'.code.toByte())
            driver.gate.countDown()
            driver.write("d") shouldBe TimedWriter.Outcome.WRITTEN
            driver.taken shouldContainExactly listOf("abc", "d")
        }
    }
})
