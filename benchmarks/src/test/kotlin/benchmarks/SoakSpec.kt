package benchmarks

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.longs.shouldBeLessThan
import io.kotest.matchers.shouldBe
import kotlin.time.Duration.Companion.hours

private const val AGENTS = 100
private const val MB = 1024 * 1024L

/** Seconds; `./argo bench soak` asks for ten minutes. */
private val SECONDS = Integer.getInteger("argo.soak.seconds", 9)

class SoakSpec : FunSpec({
    test("a hundred agents on a hundred boards leave no action unaccounted for, and neither heap nor threads grow").config(timeout = 2.hours, blockingTest = true) {
        val result = Soak(AGENTS, SECONDS).run()
        with(result) {
            println("measured: $AGENTS agents at 50 Hz for $SECONDS s: heap ${heapEarly / MB} MB, then ${heapLate / MB} MB; threads $threadsEarly, then $threadsLate; " +
                "$answers answers; $confirmed actions confirmed, $failed failed, $carriedOut carried out, $twice twice, $lost lost")
            twice shouldBe 0
            lost shouldBe 0
            confirmed shouldBeGreaterThan 0L
            carriedOut shouldBeLessThan confirmed + failed + 1
            threadsLate shouldBeLessThanOrEqual threadsEarly + 2 // those of the test's own come and go
            heapLate shouldBeLessThan heapEarly + heapEarly / 4 + 8 * MB
        }
    }
})
