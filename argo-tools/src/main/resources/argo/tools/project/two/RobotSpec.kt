import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.time.Duration.Companion.seconds

class RobotSpec : FunSpec({
    fun TestAgent.eyes() = board("replay:recordings/drive.rec")
    fun TestAgent.lamp() = board("replay:recordings/lamp.rec")

    test("the robot turns the LED of its lamp on while something is near in front of its eyes") {
        agent("robot.asl").use { robot ->
            robot.eyes().shows("dist(front,30)", "dist(left,90)")
            robot.shouldSend("ledOn")
            robot.eyes().shows("dist(front,90)", "dist(left,20)")
            robot.shouldSend("ledOff")
            robot.lamp().commands shouldBe listOf("ledOn", "ledOff")
        }
    }

    test("it turns the LED off when nothing is in sight any more") {
        agent("robot.asl").use { robot ->
            robot.eyes().shows("dist(front,30)")
            robot.shouldSend("ledOn")
            robot.eyes().shows("dist(left,90)")
            robot.shouldSend("ledOff")
        }
    }

    test("things beside it do not reach its beliefs") {
        agent("robot.asl").use { robot ->
            robot.eyes().shows("dist(front,90)", "dist(left,20)")
            robot.shouldBelieve("eyes::dist(front,90)").shouldNotBelieve("eyes::dist(left,_)")
        }
    }

    test("it sees on while the cable of its lamp is out") {
        agent("robot.asl").use { robot ->
            robot.eyes().shows("dist(front,90)")
            robot.shouldBelieve("eyes::dist(front,90)").lamp().disconnects()
            robot.shouldPrint("there is no board")
            robot.eyes().shows("dist(front,80)")
            robot.shouldBelieve("eyes::dist(front,80)").lamp().reconnects()
            robot.shouldBelieve("not port(_,off)", within = 5.seconds) // in virtual time
            robot.eyes().shows("dist(front,30)")
            robot.shouldSend("ledOn")
        }
    }
})
