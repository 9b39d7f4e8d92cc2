import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import kotlin.time.Duration.Companion.seconds

class WallSpec : FunSpec({
    test("the robot turns away from a wall, and drives on when the way is free") {
        val robot = autoClose(agent("wall.asl"))
        robot.perceives("dist(front,90)").shouldSend("drive")
        robot.perceives("dist(front,25)").shouldSend("stop").shouldSend("turn(left)")
        robot.perceives("dist(front,40)").shouldSendNothingElse()
        robot.perceives("dist(front,80)").shouldSend("drive")
    }

    test("it reports a cable that is out") {
        val robot = autoClose(agent("wall.asl"))
        robot.perceives("dist(front,90)").shouldSend("drive")
        robot.board.disconnects()
        robot.shouldPrint("no line to /tmp/ttyUNO", within = 2.seconds)
    }
})
