import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import kotlin.time.Duration.Companion.seconds

class TroubleSpec : FunSpec({
    test("the robot says so when its cable is out") {
        val robot = autoClose(agent("robot.asl"))
        robot.perceives("dist(front,90)").shouldSend("front")
        robot.board.disconnects()
        robot.shouldPrint("port ttyACM0 is off", within = 2.seconds)
    }

    test("the robot says so when its port is not free, whatever the sensing policy") {
        val robot = autoClose(agent("robot.asl") {
            options("argo_sensing" to "every")
            board("ttyACM0").belongsTo("another program")
        })
        robot.shouldPrint("port ttyACM0 is off").shouldBelieve("port(ttyACM0,off)")
    }
})
