package samples.collision

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeBetween
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.long
import io.kotest.property.arbitrary.pair
import io.kotest.property.checkAll
import samples.collision.Course.State.COLLIDED
import samples.collision.Course.State.DRIVING
import samples.collision.Course.State.STANDING
import samples.collision.Course.State.STOPPED

private const val S = 1_000_000_000L

class CourseSpec : FunSpec({
    val standing = Course.standing(5 * S)

    test("the robot stands 2 m from the wall until it is told to drive") {
        standing.distanceAt(1000 * S) shouldBe 200.0
        standing.stateAt(1000 * S) shouldBe STANDING
        standing.departure shouldBe null
    }

    test("it drives 10 cm in a second") {
        val driving = standing.drive(10 * S)
        driving.distanceAt(10 * S) shouldBe 200.0
        driving.distanceAt(11 * S) shouldBe (190.0 plusOrMinus 1e-6)
        driving.stateAt(11 * S) shouldBe DRIVING
        driving.departure shouldBe 10 * S
    }

    test("it stays where it was stopped") {
        val stopped = standing.drive(10 * S).stop(14 * S)
        stopped.distanceAt(99 * S) shouldBe (160.0 plusOrMinus 1e-6)
        stopped.stateAt(99 * S) shouldBe STOPPED
        stopped.halt shouldBe 14 * S
    }

    test("a stopped robot drives on when it is told to") {
        val again = standing.drive(10 * S).stop(14 * S).drive(20 * S)
        again.distanceAt(21 * S) shouldBe (150.0 plusOrMinus 1e-6)
        again.halt shouldBe null
        again.departure shouldBe 10 * S
    }

    test("a command that asks for what it does already changes nothing") {
        val driving = standing.drive(10 * S)
        driving.drive(12 * S) shouldBe driving
        standing.stop(12 * S) shouldBe standing
        val stopped = driving.stop(12 * S)
        stopped.stop(13 * S) shouldBe stopped
    }

    test("it collides after 20 s and no command helps it then") {
        val driving = standing.drive(10 * S)
        driving.stateAt(30 * S - 1) shouldBe DRIVING
        driving.stateAt(30 * S) shouldBe COLLIDED
        driving.distanceAt(40 * S) shouldBe 0.0
        driving.stop(31 * S).stateAt(32 * S) shouldBe COLLIDED
        driving.drive(31 * S) shouldBe driving
    }

    test("it reaches a distance when it has driven so far, also after a rest") {
        val course = standing.drive(10 * S).stop(14 * S).drive(20 * S)
        course.reached(180.0, 30 * S) shouldBe 12 * S
        course.reached(150.0, 30 * S) shouldBe 21 * S
        course.reached(150.0, 20 * S) shouldBe null
        course.reached(0.0, 99 * S) shouldBe 36 * S
    }

    test("whatever it is told, it comes no nearer than 10 cm a second and never goes back") {
        checkAll(Arb.list(Arb.pair(Arb.long(0L..3 * S), Arb.boolean()), 0..20)) { commands ->
            var now = 5 * S
            var course = standing
            for ((pause, drive) in commands) {
                val before = course.distanceAt(now)
                val expected = before - pause / 1e9 * 10
                now += pause
                course.distanceAt(now).shouldBeBetween(maxOf(0.0, expected), before, 1e-6)
                course = if (drive) course.drive(now) else course.stop(now)
            }
        }
    }

    test("where it was at the instant it reached a distance is that distance") {
        checkAll(Arb.long(0L..40 * S), Arb.long(1L..199L)) { until, cm ->
            val course = standing.drive(10 * S)
            val now = 10 * S + until
            val reached = course.reached(cm.toDouble(), now)
            if (course.distanceAt(now) > cm) reached shouldBe null
            else course.distanceAt(reached.shouldNotBeNull()) shouldBe (cm.toDouble() plusOrMinus 1e-6)
        }
    }
})
