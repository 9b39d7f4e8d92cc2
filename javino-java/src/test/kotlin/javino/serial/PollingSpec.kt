package javino.serial

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.longs.shouldBeGreaterThanOrEqual
import io.kotest.matchers.longs.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import java.util.concurrent.TimeUnit

class PollingSpec : FunSpec({
    test("a driver is asked four times a millisecond while bytes come, and once on a line that has long been still") {
        SerialTransport.pollNanos(0) shouldBe TimeUnit.MICROSECONDS.toNanos(250)
        SerialTransport.pollNanos(TimeUnit.SECONDS.toNanos(10)) shouldBe TimeUnit.MILLISECONDS.toNanos(1)
    }

    test("bytes wait for at most an eighth of the stillness before them, or a quarter of a millisecond, and never for more than one") {
        checkAll(Arb.long(0L..TimeUnit.HOURS.toNanos(1))) { still ->
            val poll = SerialTransport.pollNanos(still)
            poll shouldBeGreaterThanOrEqual TimeUnit.MICROSECONDS.toNanos(250)
            poll shouldBeLessThanOrEqual maxOf(TimeUnit.MICROSECONDS.toNanos(250), still / 8)
            poll shouldBeLessThanOrEqual TimeUnit.MILLISECONDS.toNanos(1)
        }
    }
})
