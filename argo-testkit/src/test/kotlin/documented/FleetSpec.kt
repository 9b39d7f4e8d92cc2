import argo.testkit.mas
import io.kotest.core.spec.style.FunSpec

class FleetSpec : FunSpec({
    test("the pilot has the body drive, and learns when it does") {
        val robot = autoClose(mas {
            agentOf("pilot", "+!patrol <- .send(body, achieve, drive(north)).")
            agentOf("body", "+!drive(D)[source(S)] <- argo.port(ttyACM0); argo.act(drive(D)); .send(S, tell, driving(D)).")
        })
        robot["pilot"].hears("user", "achieve", "patrol")
        robot["body"].shouldSend("drive(north)")
        robot["pilot"].shouldBelieve("driving(north)[source(body)]")
    }
})
