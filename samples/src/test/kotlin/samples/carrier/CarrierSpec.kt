package samples.carrier

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import samples.carrier.Carrier.Direction
import samples.carrier.Carrier.Hand
import samples.collision.HandClock

class CarrierSpec : FunSpec({
    val clock = HandClock()
    val carrier = Carrier(clock)

    test("it drives to the can and no further, takes it along, and puts it down before itself") {
        carrier.grip()
        carrier.grasp shouldBe Hand.CLOSED
        carrier.release()
        carrier.move(Direction.FORWARD)
        clock.advance(2500)
        carrier.way shouldBe (50.0 plusOrMinus 0.001)
        carrier.free shouldBe (10.0 plusOrMinus 0.001)
        carrier.move(Direction.NO)
        carrier.grip()
        carrier.grasp shouldBe Hand.FULL
        carrier.free shouldBe Carrier.FAR_CM
        carrier.move(Direction.BACKWARD)
        clock.advance(10_000)
        carrier.way shouldBe 0.0
        carrier.release()
        carrier.grasp shouldBe Hand.OPEN
        carrier.free shouldBe Carrier.REACH_CM
        carrier.move(Direction.FORWARD)
        clock.advance(10_000)
        carrier.free shouldBe 0.0
    }
})
