package samples.collision

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldMatch
import samples.collision.Course.State.COLLIDED
import samples.collision.Course.State.DRIVING
import samples.collision.Course.State.STOPPED
import kotlin.random.Random

class RobotSpec : FunSpec({
    test("its sensors say where it is") {
        val clock = HandClock()
        val robot = Robot(clock, Random(1))
        robot.act("front")
        clock.advance(10_000)
        robot.percepts().first() shouldMatch Regex("""dist\(f,10[01]\)""")
    }

    test("its lamps are switched one by one, and what it does not know changes nothing") {
        val robot = Robot(HandClock(), Random(1))
        robot.act("ledLightOn")
        robot.act("ledTempOn")
        robot.lamps shouldBe setOf("light", "temp")
        robot.act("ledLightOff")
        robot.act("dance(2)") shouldBe false
        robot.lamps shouldBe setOf("temp")
        robot.course.departure shouldBe null
    }

    test("it tells once each thing that it does") {
        val told = ArrayList<Course.State>()
        val clock = HandClock()
        val robot = Robot(clock, Random(1)) { _, state -> told += state }
        listOf("front", "front", "stop", "stop", "front").forEach(robot::act)
        clock.advance(30_000)
        repeat(2) { robot.percepts() }
        told.shouldContainExactly(DRIVING, STOPPED, DRIVING, COLLIDED)
    }
})
