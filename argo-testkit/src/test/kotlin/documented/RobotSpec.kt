import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec

class RobotSpec : FunSpec({
    test("the robot stops in front of a wall") {
        val robot = autoClose(agent("robot.asl"))
        robot.perceives("dist(front,30)")
        robot.shouldSend("stop")
    }
})
