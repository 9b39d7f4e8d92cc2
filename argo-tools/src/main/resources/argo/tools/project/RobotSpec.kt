import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import kotlin.time.Duration.Companion.seconds

class RobotSpec : FunSpec({
    test("the robot turns its LED on while something is near in front of it") {
        agent("robot.asl").use { robot ->
            robot.perceives("dist(front,30)", "dist(left,90)").shouldSend("ledOn")
            robot.perceives("dist(front,25)", "dist(left,90)").shouldSendNothingElse()
            robot.perceives("dist(front,90)", "dist(left,20)").shouldSend("ledOff")
        }
    }

    test("it turns the LED off when nothing is in sight any more") {
        agent("robot.asl").use { robot ->
            robot.perceives("dist(front,30)").shouldSend("ledOn")
            robot.perceives("dist(left,90)").shouldSend("ledOff")
        }
    }

    test("things beside it do not reach its beliefs") {
        agent("robot.asl").use { robot ->
            robot.perceives("dist(front,90)", "dist(left,20)").shouldBelieve("dist(front,90)").shouldNotBelieve("dist(left,_)")
        }
    }

    test("it looks for its board again when the cable was out") {
        agent("robot.asl").use { robot ->
            robot.perceives("dist(front,90)")
            robot.board.disconnects()
            robot.shouldPrint("there is no board")
            robot.board.reconnects()
            robot.perceives("dist(front,30)", within = 5.seconds).shouldSend("ledOn") // in virtual time
        }
    }
})
