package experiment

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import samples.collision.Course
import samples.collision.Sensors
import kotlin.random.Random

private const val S = 1_000_000_000L

class MeasuredSpec : FunSpec({
    val driving = Course.standing(0).drive(0)

    test("nothing is measured while the robot stands at the start or drives") {
        measured(Course.standing(0), 80, null, 5 * S) shouldBe null
        measured(driving, 80, null, 5 * S) shouldBe null
    }

    test("a stop is measured from the limit, which the robot crosses after 12 s, and from when its agent perceived the wall") {
        val stop = measured(driving.stop(12 * S + S / 4), 80, 12 * S + S / 10, 20 * S).shouldNotBeNull()
        stop.outcome shouldBe Outcome.STOPPED
        stop.distance shouldBe (77.5 plusOrMinus 1e-6)
        stop.sinceLimitMs shouldBe (250.0 plusOrMinus 1e-6)
        stop.sincePerceivingMs.shouldNotBeNull() shouldBe (150.0 plusOrMinus 1e-6)
    }

    test("a board that stops its robot does so before the agent perceives the wall") {
        val stop = measured(driving.stop(12 * S + S / 4), 80, 12 * S + S / 2, 20 * S).shouldNotBeNull()
        stop.sincePerceivingMs.shouldNotBeNull() shouldBe (-250.0 plusOrMinus 1e-6)
    }

    test("the wall is perceived with the first reading at or below the limit, and the limit crossed since the one before") {
        val sighting = Sighting(80)
        sighting.see(83.0, S)
        sighting.see(null, 2 * S)
        sighting.see(82.0, 3 * S)
        listOf(sighting.perceived, sighting.crossed) shouldBe listOf(null, null)
        sighting.see(78.0, 5 * S)
        sighting.see(82.0, 6 * S)
        sighting.see(70.0, 7 * S)
        sighting.perceived shouldBe 5 * S
        sighting.crossed shouldBe 4 * S
    }

    test("a robot that is first seen behind the limit has crossed it by then") {
        Sighting(80).apply { see(80.0, S) }.crossed shouldBe S
    }

    test("a collision is measured to the wall, 8 s behind a limit of 80 cm") {
        val wall = measured(driving, 80, 15 * S, 30 * S).shouldNotBeNull()
        wall.outcome shouldBe Outcome.COLLIDED
        wall.distance shouldBe 0.0
        wall.sinceLimitMs shouldBe (8000.0 plusOrMinus 1e-6)
        wall.sincePerceivingMs.shouldNotBeNull() shouldBe (5000.0 plusOrMinus 1e-6)
        measured(driving, 80, null, 30 * S).shouldNotBeNull().sincePerceivingMs shouldBe null
    }

    test("a stop before the limit took no time") {
        measured(driving.stop(S), 80, null, 2 * S).shouldNotBeNull().sinceLimitMs shouldBe 0.0
    }

    test("more sensors are further sets with names of their own, and all of them change") {
        val sensors = Sensors(Random(1), 4)
        val frames = List(2) { sensors.frame(150.0) }
        frames.first().map { it.substringBeforeLast(',') }.toSet().size shouldBe 48
        frames.first().zip(frames.last()).none { (one, other) -> one == other } shouldBe true
        frames.first().count { it.startsWith("dist(f,") } shouldBe 1
    }

    test("time that is too short to wait for is owed on") {
        val time = SlowTime(3.0)
        time.owedAfter(60_000) shouldBe 0
        time.owedAfter(60_000) shouldBe 240_000
        time.paid(250_000)
        time.owedAfter(100_000) shouldBe 0 // 190,000 minus the excess of the last wait
        time.owedAfter(10_000) shouldBe 210_000
    }

    test("a computer that is as fast owes nothing") {
        SlowTime(1.0).owedAfter(5 * S) shouldBe 0
    }

    test("there are 1229 primes up to 10,000, which is what the calibration counts") {
        Calibration.primes(10_000) shouldBe 1229
        Calibration.primes(10) shouldBe 4
    }

    test("a slower computer than the one of 2016 is not sped up") {
        Calibration.slowdown(100.0) shouldBe 1.0
        Calibration.slowdown(Calibration.REFERENCE_EVENTS_PER_S * 4) shouldBe 4.0
    }

    test("the calibration counts the events of the time that it is given") {
        var now = 0L
        val events = Calibration.eventsPerSecond { now.also { now += 50_000_000 } }
        events shouldBe (20.0 plusOrMinus 5.0)
    }
})
