package argo.recording

import argo.recording.replay.ClockDifference
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.longs.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import kotlin.math.abs

class ClockDifferenceSpec : FunSpec({
    test("messages both ways bound the difference, however long they take") {
        val delays = Arb.list(Arb.long(0L..1_000_000_000L), 1..20)
        checkAll(Arb.long(-1_000_000_000_000L..1_000_000_000_000L), delays, delays) { ahead, there, back ->
            val found = ClockDifference.of(there.map { it + ahead }, back.map { it - ahead })!!
            abs(found.ns - ahead) shouldBeLessThanOrEqual found.withinNs!! + 1
            found.messages shouldBe there.size + back.size
        }
    }

    test("messages one way show it but for the time that they take, and without messages nothing is known") {
        ClockDifference.of(listOf(5, 3), emptyList()) shouldBe ClockDifference(3, null, 2)
        ClockDifference.of(emptyList(), listOf(5, 3)) shouldBe ClockDifference(-3, null, 2)
        ClockDifference.of(emptyList(), emptyList()) shouldBe null
    }

    test("in words it says how exact it is") {
        "${ClockDifference(1_250_000_000, 400_000, 12)}" shouldBe "1.250 s ahead, give or take 0.4 ms, by 12 messages"
        "${ClockDifference(-2_000_000_000, null, 1)}" shouldBe "2.000 s behind, but for the time that a message takes, by one message"
    }
})
