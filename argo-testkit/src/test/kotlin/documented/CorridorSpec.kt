import argo.testkit.agent
import argo.testkit.replayed
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import kotlin.time.Duration.Companion.milliseconds

class CorridorSpec : FunSpec({
    val drive = "${tempdir().resolve("corridor.mcap")}" // of a real drive a file in src/test/resources

    beforeSpec {
        agent("robot.asl") { options("argo_record" to drive) }.use { robot ->
            robot.perceives("dist(front,90)").perceives("dist(front,30)").shouldSend("stop")
        }
    }

    test("the robot does in the corridor what it did") {
        replayed(drive, agent = "robot", program = "robot.asl").shouldSendTheSame(within = 50.milliseconds)
    }
})
