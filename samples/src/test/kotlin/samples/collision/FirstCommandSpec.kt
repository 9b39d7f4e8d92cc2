package samples.collision

import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotContain
import kotlin.io.path.Path
import kotlin.time.Duration.Companion.seconds

class FirstCommandSpec : FunSpec({
    fun robot(): TestAgent = agent(Path("collision/robot.asl")) {
        options("beliefs" to "board(robot,[]), value(40), interval(20), view(none)")
        board("robot").version2().shows("dist(f,100)")
    }

    test("after a first command that the robot refuses, the agent does not believe that it drives") {
        robot().use {
            it.board("robot").refuses("front")
            it.shouldBelieve("trouble(_)", within = 5.seconds)
            it.beliefs shouldNotContain "status(front)"
        }
    }

    test("after a first command that may have arrived, the agent believes that the robot drives") {
        robot().use {
            it.board("robot").takes(60.seconds, "front")
            it.after(1.seconds).board("robot").disconnects()
            it.shouldBelieve("trouble(_) & status(front)", within = 60.seconds)
        }
    }
})
