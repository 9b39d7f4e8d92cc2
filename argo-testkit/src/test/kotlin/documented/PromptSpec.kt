import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import kotlin.time.Duration.Companion.milliseconds

class PromptSpec : FunSpec({
    test("the robot stops within 250 ms of the wall coming close") {
        val robot = autoClose(agent("robot.asl"))
        robot.perceives("dist(front,90)").shouldSend("front")
        val before = robot.now
        robot.perceives("dist(front,30)").shouldSend("stop", within = 250.milliseconds, since = before)
    }
})
