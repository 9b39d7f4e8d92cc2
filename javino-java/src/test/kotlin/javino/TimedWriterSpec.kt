package javino

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.util.concurrent.CountDownLatch
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.TimeUnit

private fun inAWhile(millis: Long = 20_000) = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis)

/** A driver that takes bytes only when its gate is open. */
private class Gated : AutoCloseable {
    val gate = CountDownLatch(1)
    val begun = CountDownLatch(1)
    val taken = CopyOnWriteArrayList<String>()
    val writer = TimedWriter("gated") { bytes ->
        begun.countDown()
        gate.await()
        taken += bytes.decodeToString()
        check(bytes.decodeToString() != "worse") { "a driver that throws" }
        if (bytes.decodeToString() == "bad") -1 else bytes.size
    }.apply { start() }

    fun write(text: String, deadline: Long = inAWhile()) = writer.write(text.toByteArray(), 0, text.length, deadline)

    override fun close() {
        writer.close()
        gate.countDown()
    }
}

class TimedWriterSpec : FunSpec({
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
            driver.write("first", inAWhile(20)) shouldBe TimedWriter.Outcome.TOO_LATE
            driver.begun.await()
            driver.write("given up", inAWhile(20)) shouldBe TimedWriter.Outcome.TOO_LATE
            driver.gate.countDown()
            driver.write("second") shouldBe TimedWriter.Outcome.WRITTEN
            driver.taken shouldContainExactly listOf("first", "second")
        }
    }

    test("closing ends a write that waits") {
        Gated().use { driver ->
            val write = async { driver.write("abc") }
            driver.begun.await()
            driver.writer.close()
            write.get(20, TimeUnit.SECONDS) shouldBe TimedWriter.Outcome.CLOSED
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
            driver.writer.write(bytes, 0, 3, inAWhile(20)) shouldBe TimedWriter.Outcome.TOO_LATE
            bytes.fill('x'.code.toByte())
            driver.gate.countDown()
            driver.write("d") shouldBe TimedWriter.Outcome.WRITTEN
            driver.taken shouldContainExactly listOf("abc", "d")
        }
    }
})
