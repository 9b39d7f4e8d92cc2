package javino.serial

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import javino.PortInterruptedException
import javino.async
import java.time.Duration
import java.util.OptionalInt
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

private const val LIMIT_S = 20L
private const val BUSY = 16

/** Runs [work] while a driver hangs in the opening of another device. */
private fun DriverOpening.whileAnotherOpens(work: () -> Unit) {
    val begun = CountDownLatch(1)
    val ends = CountDownLatch(1)
    val slow = async {
        open("slow", { begun.countDown(); ends.await(LIMIT_S, TimeUnit.SECONDS) }, { 0 })
    }
    check(begun.await(LIMIT_S, TimeUnit.SECONDS)) { "the slow driver was not asked" }
    try {
        work()
    } finally {
        ends.countDown()
    }
    slow.get(LIMIT_S, TimeUnit.SECONDS) shouldBe OptionalInt.empty()
}

class DriverOpeningSpec : FunSpec({
    test("a device that the driver opens is open, of one that it does not open the code is given") {
        val openings = DriverOpening(Duration.ofDays(1))
        openings.open("one", { true }, { BUSY }) shouldBe OptionalInt.empty()
        openings.open("two", { false }, { BUSY }) shouldBe OptionalInt.of(BUSY)
    }

    test("a device whose driver takes long does not hold up another, whose code is not sure then") {
        val openings = DriverOpening(Duration.ofMillis(1))
        openings.whileAnotherOpens {
            openings.open("quick", { true }, { BUSY }) shouldBe OptionalInt.empty()
            openings.open("quick", { false }, { BUSY }) shouldBe OptionalInt.of(DriverOpening.UNKNOWN_CODE)
        }
    }

    test("an opening that waits for another ends with an interrupt") {
        val openings = DriverOpening(Duration.ofDays(1))
        openings.whileAnotherOpens {
            val failure = CompletableFuture<Throwable?>()
            val waiting = thread(isDaemon = true) {
                failure.complete(runCatching { openings.open("waiting", { true }, { 0 }) }.exceptionOrNull())
            }
            waiting.interrupt()
            failure.get(LIMIT_S, TimeUnit.SECONDS).shouldBeInstanceOf<PortInterruptedException>().port() shouldBe "waiting"
        }
    }
})
