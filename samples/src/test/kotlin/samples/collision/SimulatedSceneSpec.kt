package samples.collision

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import kotlin.random.Random

class SimulatedSceneSpec : FunSpec({
    class Run(limit: Int) {
        val clock = HandClock()
        val robot = Robot(clock, Random(1))
        var beliefs = Witness.Beliefs()
        val scene = SimulatedScene(robot, { beliefs }, limit, clock)

        fun stop() {
            robot.act("stop")
            beliefs = beliefs.copy(status = "stopped")
        }
    }

    test("a run lasts until the robot has stopped or collided") {
        val run = Run(40)
        run.scene.verdict() shouldBe null
        run.robot.act("front")
        run.clock.advance(15_000)
        run.scene.verdict() shouldBe null
    }

    test("it is seen by distance, deed and time") {
        val run = Run(40)
        run.scene.look() shouldBe listOf("distance 200.0 cm", "standing", "0.0 s")
        run.clock.advance(300)
        run.robot.act("front")
        run.clock.advance(11_270)
        run.scene.look() shouldBe listOf("distance 87.3 cm", "driving", "11.3 s")
    }

    test("a stop is told by distance and by the time since the limit was crossed") {
        val run = Run(40)
        run.robot.act("front")
        run.clock.advance(16_142)
        run.stop()
        run.clock.advance(500)
        val verdict = run.scene.verdict().shouldNotBeNull()
        verdict.sentence shouldBe "stopped 38.6 cm from the wall, 142 ms after the 40 cm limit"
        verdict.exitStatus shouldBe 0
    }

    test("a robot that waits for its board to answer has not ended its run") {
        val run = Run(40)
        run.robot.act("front")
        run.beliefs = Witness.Beliefs(status = "front")
        run.clock.advance(1000)
        run.robot.act("stop")
        run.scene.verdict() shouldBe null
        run.robot.act("front")
        run.scene.verdict() shouldBe null
    }

    test("a stop before the limit is told as such") {
        val run = Run(40)
        run.robot.act("front")
        run.clock.advance(1000)
        run.stop()
        run.scene.verdict().shouldNotBeNull().sentence shouldBe "stopped 190.0 cm from the wall, before the 40 cm limit"
    }

    test("a collision is told in words and by the exit status, also when the stop comes a moment later") {
        val run = Run(40)
        run.robot.act("front")
        run.clock.advance(20_050)
        run.stop()
        val verdict = run.scene.verdict().shouldNotBeNull()
        verdict.sentence shouldBe "ran into the wall: the agent had not stopped the robot 4.0 s after the 40 cm limit"
        verdict.exitStatus shouldBe 1
    }
})
