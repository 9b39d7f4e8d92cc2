package samples.project

import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldHaveSize
import kotlin.io.path.Path
import kotlin.time.Duration.Companion.seconds

class NewAgentSpec : FunSpec({
    val program = Path("../argo-tools/src/main/resources/argo/tools/project/robot.asl")
    val port = "replay:recordings/drive.rec"

    test("without a board it tries again every two seconds, in one intention") {
        agent(program) { board(port).disconnects() }.use { robot ->
            robot.after(9.seconds)
            robot.printed.filter { "argo.port" in it } shouldHaveSize 5
            robot.intentions.filter { "start" in it } shouldHaveSize 1
        }
    }

    test("while its cable is out it leaves the reopening to ARGO") {
        agent(program).use { robot ->
            robot.shouldBelieve("port(_,on)")
            robot.board.disconnects()
            robot.shouldPrint("there is no board").shouldNotIntend("start", during = 5.seconds)
            robot.board.reconnects()
            robot.shouldBelieve("port(_,on)", within = 3.seconds)
        }
    }
})
