import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import kotlin.time.Duration.Companion.seconds

class CarefulSpec : FunSpec({
    fun TestAgent.isToGo() = hears("user", "achieve", "go")

    test("it does not go by percepts that are too old") {
        val robot = autoClose(agent("careful.asl") { board.version2() })
        robot.perceives("dist(front,90)").isToGo().shouldSend("drive")
        robot.board.hangs()
        robot.shouldBelieve("argo.age(dist(front,_),Ms) & Ms >= 300").isToGo().shouldPrint("too old to go by")
        robot.shouldBelieve("stale(ttyACM0)", within = 2.seconds)
    }

    test("what is critical stops it before it reasons, once") {
        val robot = autoClose(agent("careful.asl") { board.version2() })
        robot.perceives("dist(front,90)").shouldSendNothingElse()
        robot.perceives("dist(front,9)").shouldSend("stop")
        robot.perceives("dist(front,8)").shouldSendNothingElse()
    }

    test("it says so when its board refuses, and when it does not say in time that it drives") {
        val robot = autoClose(agent("careful.asl") { board.version2().refuses("drive") })
        robot.perceives("dist(front,90)").isToGo().shouldPrint("not driving: act_refused")
        robot.board.accepts("drive")
        robot.isToGo().shouldPrint("driving")
        robot.board.takes(2.seconds, "drive")
        robot.isToGo().shouldPrint("not driving: act_unconfirmed")
    }

    test("it fails while its cable is out, and goes on when that is back") {
        val robot = autoClose(agent("careful.asl") { board.version2() })
        robot.perceives("dist(front,90)")
        robot.board.disconnects()
        robot.isToGo().shouldPrint("not driving: port_gone").shouldBelieve("port(ttyACM0,off)")
        robot.board.reconnects()
        robot.shouldBelieve("port(ttyACM0,on)", within = 3.seconds).perceives("dist(front,80)").isToGo().shouldSend("drive")
    }
})
